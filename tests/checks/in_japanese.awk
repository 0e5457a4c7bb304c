# Says in Japanese what comes in English, line by line; what the table does not have stays as it is.
#   ... | LC_ALL=C awk -f in_japanese.awk japanese.txt -
# The table is explained on its top. `known`: what was said last is in it.
FNR == NR {
  if (/^#/) next
  if ($0 == "") { english = ""; next }
  if (english == "") { english = $0; next }
  if (english ~ /[{]/) { pattern[++patterns] = english; meaning[patterns] = $0 } else exact[english] = $0
  if (english in exact && english ~ /, | and /) whole[++wholes] = english
  if (sub(/,$/, "", english)) { # at the end of a sentence its last comma is gone
    last[english] = $0
    whole[++wholes] = english
  }
  next
}
{ print said($0, 0); fflush() }

function said(text, depth,   i, k, given, words, sure) {
  known = 1
  if (text in exact) return exact[text]
  for (i = 1; i <= patterns; i++) {
    if (!fits(text, pattern[i], depth, given)) continue
    words = meaning[i]
    sure = 1
    for (k = 1; k in given; k++) {
      if (given[k, "kind"] == ";") given[k] = in_turn(given[k], depth + 1)
      else if (given[k, "kind"] == ".") given[k] = listed(given[k], depth + 1)
      else if (given[k, "kind"] != "=") given[k] = said(given[k], depth + 1)
      if (given[k, "kind"] == "." && !known) sure = 0
    }
    for (k--; k > 0; k--) words = put(words, "{" k "}", given[k])
    known = sure
    return words
  }
  known = text !~ /[A-Za-z][a-z][a-z]/ # "p1 - p2" is the same
  return text
}

function fits(text, like, depth, given,   k, from, to, then, at) { # given[1], ...: what stands for {1}, ...
  split("", given)
  if (like ~ /^[.][.][.]/) { # inside a sentence only
    if (depth == 0) return 0
    like = substr(like, 4)
  }
  at = index(like, "{")
  if (substr(text, 1, at - 1) != substr(like, 1, at - 1)) return 0
  text = substr(text, at)
  like = substr(like, at)
  for (k = 1; like != ""; k++) { # here `like` begins with {k}, {k...}, {k;} or {k=}
    from = index(like, "}")
    given[k, "kind"] = substr(like, from - 1, 1)
    like = substr(like, from + 1)
    to = index(like, "{")
    then = to ? substr(like, 1, to - 1) : like
    if (to) at = index(text, then)
    else at = length(text) - length(then) + 1
    if (at < 1 || substr(text, at, length(then)) != then) return 0
    given[k] = substr(text, 1, at - 1)
    text = substr(text, at + length(then))
    like = to ? substr(like, to) : ""
  }
  return 1
}

function listed(text, depth,   at, head, rest, sep) { # "A, B and C": A、B、C, when all of them are known
  if (text in exact) { known = 1; return exact[text] }
  if (text in last) { known = 1; return last[text] }
  text = guarded(text)
  for (at = 2; at < length(text); at++) {
    sep = substr(text, at, 5) == " and " ? 5 : substr(text, at, 2) == ", " ? 2 : 0
    if (!sep) continue
    head = said(plain(substr(text, 1, at - 1)), depth)
    if (!known) continue
    rest = plain(substr(text, at + sep))
    if (rest in exact && rest !~ /sign$/ && index(substr(text, 1, at), " in place of ")) continue # of two things
    rest = listed(rest, depth)
    if (known) return head "、" rest
  }
  return said(plain(text), depth)
}

function guarded(text,   i, at, name) { # "g, without the mass" is one thing: its comma is none of a list
  for (i = 1; i <= wholes; i++) {
    while ((at = index(text, whole[i])) > 0) {
      name = whole[i]
      gsub(/, /, "\001", name)
      gsub(/ and /, "\002", name)
      text = substr(text, 1, at - 1) name substr(text, at + length(whole[i]))
    }
  }
  return text
}
function plain(text) {
  gsub(/\001/, ", ", text)
  gsub(/\002/, " and ", text)
  return text
}

function in_turn(text, depth,   at) { # "A; B; C"
  at = index(text, "; ")
  return at ? listed(substr(text, 1, at - 1), depth) "；" in_turn(substr(text, at + 2), depth) : listed(text, depth)
}

function put(text, name, value,   at, before, after) { # with a space between a Latin letter and a Japanese one
  at = index(text, name)
  before = substr(text, 1, at - 1)
  after = substr(text, at + length(name))
  if (value ~ /^[A-Za-z`]/ && before ~ /(\343[\201-\203].|[\344-\351]..)$/) before = before " "
  if (value ~ /[A-Za-z`)|]$|[a-z][0-9]$/ && after ~ /^(\343[\201-\203]|[\344-\351])/) after = " " after
  return at ? before value after : text
}
