#pragma once

#include "poses/NextPoses.hpp"

namespace naocal {

/// NextPoses for any robot. A NAO's are those of `proposeNextPoses`. Of any other robot, candidates are drawn among
/// what measured it in the last set, at the places of the fit (ScenePoses), for the fitted robot: within the angles of
/// that set, widened by half their span and at least 0.3 rad (0.03 m) both ways. It stands as it stood; on a sole it
/// stands anew. Contacts are not planned. Reproducible by seed.
NextPoses proposeSceneNextPoses(const FittedModel& fitted, const ModelAmbiguity& question,
                                const NextPosesOptions& options = {});

/// The same for the last model of a diagnosis and its open question: the one way of commands, panel and Python. Where
/// proposing is refused, `whyNone` says why: the diagnosis stands all the same.
NextPoses proposeSceneNextPoses(const Measurements& measurements, const Diagnosis& diagnosis,
                                const DiagnosisOptions& asked, const NextPosesOptions& options = {});

} // namespace naocal
