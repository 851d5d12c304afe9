// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/OpenedVolume.h"

#include "ui/texts/ProblemTexts.h"

#include <QDebug>

#include <algorithm>
#include <cmath>

using core::VolumeProblem;

namespace test {

double valueAt(const core::LoadedVolume& loaded, const glm::ivec3& index)
{
    const glm::ivec3& size = loaded.volume.geometry.size;
    const std::size_t voxel = std::size_t(index.x)
        + std::size_t(size.x) * (std::size_t(index.y) + std::size_t(size.y) * std::size_t(index.z));
    return loaded.volume.encoding.value(loaded.codes.at(voxel));
}

double worstError(const core::LoadedVolume& loaded, const SyntheticSeries& series)
{
    double worst = 0.0;
    for (int k = 0; k < series.size.z; ++k) {
        for (int j = 0; j < series.size.y; ++j) {
            for (int i = 0; i < series.size.x; ++i) {
                const double off = valueAt(loaded, {i, j, k}) - series.value({i, j, k});
                worst = std::max(worst, std::abs(off));
            }
        }
    }
    return worst;
}

bool hasProblem(const std::vector<VolumeProblem>& problems, VolumeProblem::Kind kind)
{
    return std::any_of(problems.begin(), problems.end(),
        [&](const VolumeProblem& problem) { return problem.kind == kind; });
}

QString problemText(const std::vector<VolumeProblem>& problems, VolumeProblem::Kind kind)
{
    for (const VolumeProblem& problem : problems) {
        if (problem.kind == kind)
            return ui::problemText(problem.said);
    }
    return {};
}

QString errorText(const core::Error& error)
{
    return QStringLiteral("%1: %2")
        .arg(int(error.code))
        .arg(error.arguments.join(QLatin1Char('|')));
}

core::LoadedVolume openVolume(const QString& path, const QString& series)
{
    core::Result<core::LoadedVolume> loaded = core::loadVolume(path, series);
    if (!loaded)
        qWarning() << errorText(loaded.error());
    return loaded ? std::move(*loaded) : core::LoadedVolume();
}

} // namespace test
