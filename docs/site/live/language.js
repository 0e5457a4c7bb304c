// What depends on the language, for the script that makes the site and for its pages.
const said = { ja: { contents: '目次', search: '検索', 'dark or light': '明るさの切り替え', 'on this page': 'このページ', 'second page': '詳しい説明', nothing: '見つかりません' } };
export const t = (text, lang) => said[lang]?.[text] ?? text;

/** How MiniSearch cuts text into words: also where there are no spaces. */
export const searched = lang => ({
  fields: ['title', 'text'], storeFields: ['title'],
  tokenize: text => globalThis.Intl?.Segmenter ? [...new Intl.Segmenter(lang, { granularity: 'word' }).segment(text)].filter(s => s.isWordLike).map(s => s.segment) : text.split(/[\s\p{P}]+/u),
});
