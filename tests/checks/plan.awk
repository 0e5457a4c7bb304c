# Reads a plan: items, each a heading "## NAME" with the lines "days:", "see:" and "number:" below it. Says what
# is missing, a sentence each; exit code 1 then.  usage: awk -v shown=NAME -f plan.awk plan.md
{ sub(/\r$/, "") }
/^## / { finish(); name = substr($0, 4); line = FNR; items++; if (items == 1) first = name; next }
items && match(tolower($0), /^[-* ]*(days?|see|number):/) {
  key = tolower(substr($0, 1, RLENGTH - 1))
  gsub(/[-* ]/, "", key)
  text = substr($0, RLENGTH + 1)
  gsub(/^[ \t]+|[ \t]+$/, "", text)
  if (text ~ /\.\.\.|^$/) next # still empty
  value[key == "days" ? "day" : key] = text
}
function back(words) { # sends the item back
  printf "%s:%d: '%s' %s\n", shown, line, name, words
  wrong = 1
}
function finish(   days, count, from, to) {
  if (!items) return
  if (!("day" in value)) back("has no day. Write the day on which you will do it: days: 1, or days: 2-3.")
  else if (value["day"] !~ /^[0-9]+( *- *[0-9]+)?$/) back("has the days '" value["day"] "'. Write days: 1, or days: 2-3.")
  else {
    count = split(value["day"], days, "-")
    from = days[1] + 0
    to = days[count] + 0
    if (from < 1 || to < from) back("has the days '" value["day"] "'. Count from day 1, upwards.")
    else if (to - from >= 3) back("takes " to - from + 1 " days. Three are the most: cut it into smaller items.")
    else if (from < last) back("begins on day " from ", and the item before it ends on day " last ". One after the other.")
    if (to > last) last = to
  }
  if (!("see" in value)) back("shows nothing. Write what one will see when it works: see: ...")
  if (!("number" in value)) back("has no check. Write the number that says whether it is right: number: ...")
  else if (value["number"] !~ /[0-9]/) back("has a check without a number: '" value["number"] "'. Work the number out beforehand.")
  delete value
}
END {
  finish()
  if (!items) { printf "%s: there is no item in it. An item is a heading, ## NAME, and below it the lines days:, see: and number:\n", shown; exit 1 }
  if (wrong) exit 1
  printf "%s: %d items, %d days. Each has a day, a thing to see, and a number that decides.\nBegin with the first: %s\n", shown, items, last, first
}
