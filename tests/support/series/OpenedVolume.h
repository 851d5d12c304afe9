// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/StudyLoader.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QString>

namespace test {

/// Opens the volume at a path. On failure it logs the reason and returns an empty volume.
[[nodiscard]] core::LoadedVolume openVolume(const QString& path, const QString& series = {});

[[nodiscard]] double valueAt(const core::LoadedVolume& loaded, const glm::ivec3& index);
/// The largest difference between the values of a synthetic series and the opened volume.
[[nodiscard]] double worstError(const core::LoadedVolume& loaded, const SyntheticSeries& series);

[[nodiscard]] bool hasProblem(
    const std::vector<core::VolumeProblem>& problems, core::VolumeProblem::Kind kind);
/// The text of a problem; empty if there is none of this kind.
[[nodiscard]] QString problemText(
    const std::vector<core::VolumeProblem>& problems, core::VolumeProblem::Kind kind);
/// The code and arguments of an error, for messages of tests.
[[nodiscard]] QString errorText(const core::Error& error);

} // namespace test
