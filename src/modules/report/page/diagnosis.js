// Puts the page about a diagnosis together.

at("verdict").classList.add(data.verdict);
showVerdict(data.sentence, data.suspicious);
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
if (data.next) at("next").textContent = data.next.poses
  ? data.next.poses + " poses are proposed in the diagnosis file: they would show what " + data.next.why + "."
  : "Captures that would show what " + data.next.why + ": naocal diagnose SET --next poses.json proposes poses for them.";
showMap(at("map"));
showCurves(at("curves"));
offerModels();
showWhatIf(at("whatIf"));
showWithin(at("within"), at("ranges"));
showShapes(at("shapes"));
