// What figures say on a Japanese page: each sentence of the C++ (and of the scripts here) that is seen, and its Japanese.
// A * stands for what is put in: a number with its unit, a name, or words that have a line of their own.
import { learn } from './words.js';

learn({
  // Buttons and labels
  play: '再生', pause: '一時停止', restart: '最初から', 'step back': '一歩戻る', 'step forward': '一歩進む', slow: 'スロー', lens: '接触レンズ',
  time: '時間', method: '解法', 'time step': '刻み幅', forces: '力', exact: '厳密解', reference: '参照解', trail: '軌跡', 'from above': '真上から', errors: '誤差と計算コスト', 'every amplitude': 'すべての振幅', section: 'ポアンカレ断面',
  energy: 'エネルギー', spring: 'ばね', motion: '運動', lost: '失われた分', sound: '音', help: 'キー一覧', 'full screen': '全画面', swing: '打つ', 'next game': '次の遊び方', 'more parameters': 'その他のパラメータ', 'copy the command': 'コマンドをコピー', copied: 'コピーしました',
  'off by *': '厳密解とのずれ *', '* force evaluations a second': '力の計算 毎秒 * 回', 'by formula, without steps': '数式による（刻みなし）', 'time runs at *': '時間の速さ *',
  'dashed: by formula': '破線：数式による', height: '高さ', 'your bet': '予想', wanted: '目標', answer: '答え', 'you are off by': '予想とのずれ', 'play and see': '再生して確かめる', 'bet again': '予想し直す',
  'how far apart': '差', 'Set your bet, then play.': '予想を決めてから再生してください。', 'pale: *': '淡い線：*', 'the other ball': 'もう一つのボール',
  'Drag the flag to your bet: *.': '旗を予想の位置まで動かしてください：*。', 'the height of the first top': '最初の頂点の高さ', 'the height of the second top': '二番目の頂点の高さ', 'the height of the third top': '三番目の頂点の高さ', 'the height of a top': '頂点の高さ',
  'when the first touch begins': '最初に触れる時刻', 'where the fourth touch begins': '四回目に触れる位置', 'where the curve ends': '曲線の終わりの値', 'It does not come to that.': 'そこまで起こりません。',

  // Parameters, and what they mean
  mass: '質量', gravity: '重力加速度', position: '位置', velocity: '速度', radius: '半径', stiffness: 'ばね定数', damping: '粘性減衰係数', contact: '接触', floor: '床', tray: '壁',
  'floor stiffness': '床のばね定数', 'floor damping': '床の粘性減衰係数', amplitude: '振幅', 'angular frequency': '角振動数', phase: '位相', 'floor velocity': '床の速度', 'floor law': '床の法則', normal: '法線ベクトル', offset: '平面の d', tilt: '傾き',
  scene: '場面', player: '打ち手', gap: '隙間', count: '個数', 'racket position': 'ラケットの位置', 'racket normal': 'ラケットの法線ベクトル', 'racket radius': 'ラケットの半径', 'racket velocity': 'ラケットの速度', mode: '遊び方', assist: '補助', strike: '打つ時', knock: 'はじめのずれ', degrees: '度',
  'how much the ball resists a force': '力を受けても動きにくい度合い', 'pulls downwards; 0 turns it off': '下向きに引く。0 でなくなる', "height of the ball's centre at the start": '開始時のボールの中心の高さ', 'speed at the start, upwards': '開始時の速さ。上向きが正',
  'the ball touches what is nearer to its centre than this': '中心からこれより近いものにボールは触れる', 'spring force per overlap': '重なりあたりのばねの力', 'damper force per speed; 0 for none': '速さあたりのダンパの力。0 でなし', 'may the damper pull the ball back at lift-off?': '離れる瞬間にダンパがボールを引き戻してよいか',
  "the ball's centre x,y,z at the start; y is up": '開始時のボールの中心 x,y,z。y が上', 'velocity x,y,z at the start; y is up': '開始時の速度 x,y,z。y が上', 'a,b,c of the plane a x + b y + c z + d = 0; its length is no matter': '平面 a x + b y + c z + d = 0 の a,b,c。長さは問わない',
  'd of the plane; in metres when the normal has length 1': '平面の d。法線ベクトルの長さが 1 ならメートル', 'is there a floor at height 0?': '高さ 0 に床があるか', 'turns plane and ball together; positive: downhill along x': '平面とボールを一緒に回す。正なら x の向きに下り坂',
  'the same for floor and walls': '床と壁の値', 'walls at x = 0 and LX, z = 0 and LZ; 0 for none': '壁は x = 0 と LX、z = 0 と LZ。0 でなし', 'the balls at the start; it brings its own defaults of all others': '開始時のボールの並び。他の値も場面の既定値になる', 'balls of break, cradle and drop': 'break、cradle、drop のボールの数', 'between the balls at the start; in pair: how far off centre': '開始時のボールの間。pair では中心のずれ',
  'how far the floor swings to each side': '床が上と下に動く幅', 'how fast the floor swings; 6.283 is once a second': '床の振動の速さ。6.283 で毎秒1回', 'where in its swing the floor starts': '床が振動のどこから始まるか', 'steady speed of the floor, upwards, besides the swing': '振動のほかに床が上へ動く一定の速さ', "what the contact knows of the floor's movement": '接触の力が床の動きをどう見るか',
  "the disc's centre x,y,z at the start; in the game its home": '開始時の円板の中心 x,y,z。ゲームでは元の位置', 'of the disc; in the game it shrinks to half': '円板の半径。ゲームでは半分まで縮む', 'square to the disc, of any length; for the player none': '円板に垂直。長さは問わない。player が none のとき', 'velocity x,y,z of the disc; for the player none': '円板の速度 x,y,z。player が none のとき',
  'pulls downwards; the game begins with 4 and grows up to this': '下向きに引く。ゲームは 4 で始まり、この値まで増える', 'what counts in the game: hits, landings in a ring, or hits on the beat, unseen': 'ゲームで数えるもの。打った回数、輪に入った着地、見ないで拍子に合わせた回数',
  "the blind player's racket meets the ball while it slows down or speeds up": '目をつぶった打ち手が、ラケットの減速中に打つか、加速中に打つか', "the blind player's ball starts higher by this": '目をつぶった打ち手のボールはこれだけ高く始まる', 'how much of the aim is taken off a human player': '狙いをどれだけ助けるか',

  // Titles, questions, plots
  'Stage 1: free fall': 'ステージ1：自由落下', 'Stage 2: spring floor': 'ステージ2：ばねの床', 'Stage 3: damping': 'ステージ3：減衰', 'Stage 4: three dimensions': 'ステージ4：3次元', 'Stage 5: ball against ball': 'ステージ5：ボール同士の衝突', 'Stage 6: oscillating floor': 'ステージ6：振動する床', 'Stage 7: tilted plane': 'ステージ7：傾いた平面', 'Stage 8: the racket game': 'ステージ8：ラケットのゲーム',
  'Make dt a hundred times larger. Where does the ball of the loop end up beside the one of the formula?': 'dt を100倍にしてみましょう。ループのボールは、数式のボールと比べてどこに着きますか。',
  'A softer or a harder floor: on which of them does the ball come back higher?': '柔らかい床と硬い床、ボールが高く戻るのはどちらですか。',
  'How much damping lets the ball come back to half its height? And how much makes it stay down?': '半分の高さまで戻るのは、粘性減衰係数がいくらのときですか。もう跳ね返らないのは、いくらからですか。',
  'Press T and look from straight above. Which path does the ball draw there, and how fast does it go?': 'T を押して真上から見ましょう。ボールはどんな道を、どんな速さで進みますか。',
  'Choose the tower. How high does the small ball fly when the two touch, and how high with a gap of 0.1 m between them?': 'tower を選びましょう。二つが触れているとき、小さいボールはどこまで上がりますか。間に 0.1 m の隙間があるときはどうですか。',
  'Raise the amplitude slowly. When do the bounces stop being all alike? And what comes after that?': '振幅を少しずつ上げましょう。跳ね返りがそろわなくなるのはいつですか。その先には何がありますか。',
  'Turn off the damping. How do the distances between the landings grow? And which tilt makes the beat faster?': '減衰をなくしましょう。着地の間の距離はどう伸びますか。拍子が速くなるのはどの傾きですか。',
  'The bare physics of ball and racket. Where must the ball meet the disc, and how must the disc lean, for the ball to come back?': 'ボールとラケットだけの物理です。ボールが戻ってくるには、円板のどこに当たり、円板がどう傾いていればよいですか。',
  'position minus exact': '位置と厳密解の差', 'energy that the method made': '解法が作ったエネルギー', 'energy lost to the damper': 'ダンパが奪ったエネルギー', 'energy lost to the damper, this bounce': 'この跳ね返りでダンパが奪ったエネルギー', 'velocity along y (up)': 'y 方向（上）の速度', 'velocity along x': 'x 方向の速度', 'energy of motion': '運動エネルギー', 'energy in the springs': 'ばねのエネルギー',
  'heights of the bounces for every amplitude, m (click: go there)': 'すべての振幅での跳ね返りの高さ m（クリックで移動）', 'heights for every amplitude, m': 'すべての振幅での高さ m', "speed of each touch, m/s, by the floor's angle": '触れる瞬間の速さ m/s（横軸：床の位相）',

  // In the picture
  error: '誤差', 'arrow: x100': '矢印：100倍', now: '今', '* apart': '差 *', 'weight *': '重力 *', 'spring *': 'ばね *', 'damper *': 'ダンパ *', 'spring, peak *': 'ばねの最大 *', 'from above (T)': '真上から（T）', 'from the side (T)': '横から（T）',
  'squares * m   dots 0.1 s   force arrows: length ~ sqrt(force)': 'ます目 * m   点 0.1 s ごと   力の矢印：長さは力の平方根に比例', 'dots 0.1 s   force arrows: length ~ sqrt(force)': '点 0.1 s ごと   力の矢印：長さは力の平方根に比例',
  'speed against error': '誤差と計算コスト', 'up: force evaluations per second': '縦：力の計算の回数（毎秒）', 'across: largest error in * s [m]': '横：* s 間の最大の誤差 [m]', 'now: *, dt * s': '今：*、dt * s', 'now: *': '今：*', 'no steps, and no error but rounding': '刻みはなく、誤差は丸め誤差だけ', 'it chooses its steps itself': '刻み幅を自分で選ぶ', 'too many steps to try them here': 'ステップが多すぎて、ここでは試せない', explodes: '発散する',
  '* evaluations per s, off by *': '毎秒 * 回、ずれ *', 'There is no exact solution to compare with.': '比べる厳密解がありません。', '1 x the fall': '落下の 1 倍', '6.95 x: two collisions, one after the other': '6.95 倍：衝突が一つずつ続けて二つ', '* x': '* 倍',

  // The game
  'paused (P)': '一時停止（P）', hits: '回数', points: '得点', 'best *': '最高 *', '* hits': '* 回', '* hit': '* 回', 'keep it up': '落とさずに打ち続ける', 'target: send the ball into the ring': '的：ボールを輪に入れる', 'blind: close your eyes and swing on the beat': '目隠し：目を閉じて拍子で打つ', 'blind: a sine that never looks': '目隠し：見ないで振れる正弦波', 'the autopilot plays': '自動操縦が打っています', 'nobody plays': 'だれも打っていません',
  'gravity * m/s^2     disc * cm     assist * %': '重力加速度 * m/s^2     円板 * cm     補助 * %', 'gravity * m/s^2     disc * cm': '重力加速度 * m/s^2     円板 * cm', '*     sound off': '*     音なし', 'a top here: + 1': '頂点：+1', 'send it here': 'ここへ', 'swing when it is up': '針が上で打つ', 'push *': '押す力 *', touch: '接触',
  'mouse or arrows: move    *: tilt    Space or button: swing    G: next mode    - +: assist    F1: all keys': 'マウスか矢印：動かす    *：傾ける    Space かボタン：打つ    G：次の遊び方    - +：補助    F1：キー一覧',
  'struck while the racket slows down: it finds its height': 'ラケットの減速中に打つ：高さが定まる', 'struck while the racket speeds up: it wanders or dies': 'ラケットの加速中に打つ：定まらないか、止まる', 'height of ball and racket, 15 s': 'ボールとラケットの高さ、15 s',
  'Lost after *: your best': '* で落としました：最高記録', 'Lost after *': '* で落としました', 'again, at a quarter of the speed': '4分の1の速さでもう一度', 'any key: play on': '好きなキーで次へ',
  // A space is where a line may end.
  '* from the disc\'s centre, * beyond its rim': '円板の中心から * の所（縁の外 *）', '* from the disc\'s centre': '円板の中心から * の所', 'The ball was back after * s, *.': 'ボールは * s 後に、 *へ 戻りました。', 'The ball rose only *.': 'ボールは * しか 上がりませんでした。', 'No touch: the ball came down *.': '触れていません： ボールは *へ 落ちました。',
  'The ball did not bounce any more, and slid over the rim with *.': 'ボールは もう跳ね返らず、 縁を * で 滑り落ちました。', 'Hit over the rim, * beside the centre: the ball left to the side with *.': '中心から * 離れた 縁の外に 当たり、 ボールは 横へ * で 飛びました。', 'Hit * beside the centre, tilted by * degrees: the ball left to the side with *.': '中心から * の所に 当たりましたが、 円板が * 度 傾いていて、 ボールは 横へ * で 飛びました。',
  'The racket moved down with * at the touch, which took speed from the ball.': '触れたとき ラケットは * で 下へ動いていて、 ボールの 速さを 奪いました。', 'Too early by *: the swing was over.': '* 早すぎました： 振りは もう 終わっていました。', 'Too late by *: the racket did not move up yet.': '* 遅すぎました： ラケットは まだ 上へ 動いていませんでした。', 'No swing: the racket stood still at the touch.': '振っていません： 触れたとき ラケットは 止まっていました。', 'The swing was right, but the ball came too slowly.': '振りは よかったのですが、 ボールが 遅すぎました。', 'The hit was good, but the disc was elsewhere.': '当たりは よかったのですが、 円板が 別の所に ありました。',

  // Keys
  'P, Space': 'P、Space', 'pause, play': '一時停止、再生', '.  or Right': '. か右矢印', 'one step forward': '一歩進む', ',  or Left': ', か左矢印', 'one step back': '一歩戻る', 'slow motion (1/10)': 'スロー（10分の1）', 'contact lens: a contact lasts a second': '接触レンズ：接触を1秒に引きのばす', 'speed against error, now: click a dot to choose it': '今の誤差と計算コスト：点をクリックすると選べる', 'from above, from the side': '真上から、横から', mouse: 'マウス', 'drag the ball, and throw it': 'ボールをつかんで投げる', 'this page': 'この一覧', 'all values of a slider: click to go there': 'スライダのすべての値：クリックで移動', 'Poincare section: each touch is a point': 'ポアンカレ断面：触れるたびに点が一つ',
  'mouse, arrows': 'マウス、矢印', 'move the racket': 'ラケットを動かす', 'tilt it: left, right, away, towards you': '傾ける：左、右、奥、手前', 'Space, button': 'Space、ボタン', 'swing upwards; after a loss any key plays on': '上へ打つ。落とした後は好きなキーで次へ', 'the next mode: keep it up, target, blind': '次の遊び方：続ける、的、目隠し', '- and +': '- と +', 'less and more help with the aim': '狙いの補助を減らす、増やす', 'pause;  . and ,  one step forward and back': '一時停止。. と , で一歩進む、戻る', 'slow motion; a contact that lasts a second': 'スロー。接触を1秒に引きのばす', 'sound on and off; dark and light': '音を出す、消す。暗く、明るく', fingers: '指', 'one moves; a tap or a second one swings': '一本で動かす。たたくか二本目で打つ',

  // When something is wrong
  'dt = * s is too large to see the floor swing: take dt = * s': 'dt = * s は床の振動を見るには大きすぎます：dt = * s にしてください', '* gains energy on an undamped spring at every time step: take semi-implicit-euler with dt = *': '* は減衰のないばねで、どの刻み幅でもエネルギーが増えます：semi-implicit-euler で dt = * にしてください',
  'dt = * s is too large: * is stable up to * s on this contact, and good to look at with *': 'dt = * s は大きすぎます：* はこの接触では * s まで安定で、見るには * がよい値です', 'dt = * s is stable on this contact, but a bounce can have restitution * in place of *: take dt = * (--dt auto)': 'dt = * s はこの接触で安定ですが、反発係数が * のはずの跳ね返りで * になることがあります：dt = * にしてください（--dt auto）',
  'The state became infinite at t = * s. *': 't = * s で状態が無限大になりました。*', 'It stops soon after t = * s: *': 't = * s のすぐ後で止まります：*', "* = '*' is not allowed: it must be *": "* = '*' は使えません：使えるのは *",
  'a number from * to * (*)': '* から * までの数（*）', 'a number from * to *': '* から * までの数', 'a whole number from * to *': '* から * までの整数', '* numbers from * to *, separated by commas, not all of them 0': '* 個の数（* から *、コンマ区切り、すべてが 0 ではない）', '* numbers from * to *, separated by commas (*)': '* 個の数（* から *、コンマ区切り、*）', '* numbers from * to *, separated by commas': '* 個の数（* から *、コンマ区切り）', 'a number': '数', '* or *': '* か *',
});
