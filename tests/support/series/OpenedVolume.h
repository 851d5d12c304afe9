// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/StudyLoader.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QString>

namespace test {

/// Opens what lies at a path; where that fails, says why in the log and returns an empty volume.
[[nodiscard]] core::LoadedVolume openVolume(const QString& path, const QString& series = {});

[[nodiscard]] double valueAt(const core::LoadedVolume& loaded, const glm::ivec3& index);
/// Largest difference between what a series was made of and what was opened.
[[nodiscard]] double worstError(const core::LoadedVolume& loaded, const SyntheticSeries& series);

[[nodiscard]] bool hasProblem(
    const std::vector<core::VolumeProblem>& problems, core::VolumeProblem::Kind kind);
/// What is said about a problem; empty where there is none of that kind.
[[nodiscard]] QString problemText(
    const std::vector<core::VolumeProblem>& problems, core::VolumeProblem::Kind kind);
/// An error's code and arguments, for messages of tests.
[[nodiscard]] QString errorText(const core::Error& error);

} // namespace test
