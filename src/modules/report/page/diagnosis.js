// Puts the page about a diagnosis together.

at("verdict").classList.add(data.verdict);
at("headline").textContent = document.title = data.headline;
at("sentence").textContent = data.sentence;
for (const {figure, sentence} of data.facts) {
  const fact = at("facts").appendChild(element("div"));
  fact.append(element("dt", "", figure), element("dd", "", sentence));
}
data.suspicious.forEach(why => at("warnings").append(element("li", "", why)));
at("overLadder").hidden = !data.steps.length; // nothing could be fitted
at("overCandidates").hidden = at("overUntested").hidden = !data.candidates.length;
if (data.steps.length) showLadder(at("ladder"));
showCommand(at("command"));
offerStates();
showCandidates();
showAdded(at("added"));
showAliases(at("aliases"));
showImprint(at("imprint"));
showUntested(at("untested"));
at("overNext").hidden = !data.next;
if (data.next) at("next").textContent = data.next.poses + " poses are proposed in the diagnosis file: " + data.next.why;
showMap(at("map"));
showCurves(at("curves"));
