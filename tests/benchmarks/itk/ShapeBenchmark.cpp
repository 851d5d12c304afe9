// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/itk/ShapeBenchmark.h"

#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/engine/EngineCommands.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/benchmarks/common/Desk.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/TorsoVolume.h"
#include "tests/peers/ItkDistances.h"
#include "tests/support/scenes/PlainEdits.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace bench {

namespace {

using core::ReshapeSegment;
using core::ShapeOperation;

constexpr int slices = 400;
constexpr int rounds = 3;
constexpr double marginMm = 3.0;

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

ReshapeSegment reshape(ShapeOperation operation)
{
    return {.segment = 1, .operation = operation, .mm = marginMm};
}

double millisecondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

QString measurePreview(
    PeerReport& report, Desk& desk, const std::string& id, const core::Edit& edit)
{
    const QString name = QString::fromStdString(id);
    const auto before = desk.pictures();
    if (!desk.apply(edit))
        return name + QStringLiteral(": refused");
    const auto after = desk.pictures();
    if (!desk.undo() || desk.pictures() != before)
        return name + QStringLiteral(": undo leads elsewhere");
    for (std::size_t view = 0; view < before.size(); ++view) {
        if (before[view] == after[view])
            return name + QStringLiteral(": view %1 does not show it").arg(view);
    }
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round) {
        core::Result<void> asked;
        const std::optional<double> time =
            desk.views().untilSeen([&] { asked = desk.session().begin(edit); }, Desk::all());
        if (!asked || !time)
            return name + QStringLiteral(": no picture");
        if (desk.pictures() != after)
            return name + QStringLiteral(": the preview shows another picture than the step");
        if (!desk.end(core::Ending::Rollback) || desk.pictures() != before)
            return name + QStringLiteral(": what was seen is not taken back");
        times.push_back(*time);
    }
    report.add({id, "Ms", median(times)});
    return {};
}

/// Whether a margin is the mask of all voxels that ITK finds near enough. Its floats decide nothing
/// where they lie at the margin.
bool isMargin(const std::vector<std::uint8_t>& labels, const std::vector<float>& squared)
{
    constexpr double squaredMm = marginMm * marginMm;
    constexpr double floats = 2e-6; // of the filter; and the millionth of core::ballOf()
    if (labels.size() != squared.size())
        return false;
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
        const double away = double(squared[voxel]);
        if ((labels[voxel] == 1) != (away <= squaredMm)
            && std::abs(away - squaredMm) > floats * squaredMm)
            return false;
    }
    return true;
}

/// The whole of a margin beside ITK's distance map: worked out, the labels at hand, and as .kept
/// the whole step.
QString measureWhole(PeerReport& report, Desk& desk, const std::string& id)
{
    constexpr const char* peerName = "ITK SignedMaurerDistanceMap";
    const QString name = QString::fromStdString(id);
    const ReshapeSegment edit = reshape(ShapeOperation::Grow);
    const core::Document document = desk.session().document();
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    const auto before = desk.session().questions().labels(0);
    if (!before)
        return name + QStringLiteral(": no labels");
    const peer::ItkDistances theirs =
        peer::itkDistances(geometry.size, geometry.spacingMm(), *before);
    std::vector<double> workedOut;
    std::vector<double> kept;
    for (int round = 0; round < rounds; ++round) {
        auto start = std::chrono::steady_clock::now();
        if (!relabelListed(edit, document, *before, core::Progress()))
            return name + QStringLiteral(": refused");
        workedOut.push_back(millisecondsSince(start));
        start = std::chrono::steady_clock::now();
        if (!desk.apply(edit))
            return name + QStringLiteral(": refused");
        kept.push_back(millisecondsSince(start));
        const auto after = desk.session().questions().labels(0);
        if (!after || *after == *before || !isMargin(*after, theirs.squared))
            return name + QStringLiteral(": not what ITK finds");
        if (!desk.undo())
            return name + QStringLiteral(": undo leads elsewhere");
    }
    report.add({id, "Ms", median(workedOut), peerName, theirs.milliseconds});
    report.add({id + ".kept", "Ms", median(kept), peerName, theirs.milliseconds});
    return {};
}

/// The liver, grown from a line in its middle, with what noise leaves out.
bool makeLiver(Desk& desk)
{
    constexpr int reach = 5;
    std::vector<glm::dvec3> pointsLps;
    for (int x = -reach; x <= reach; ++x)
        pointsLps.push_back(TorsoVolume::liverLps() + glm::dvec3(x, 0.0, 0.0));
    return desk.apply(test::seedAt(1, std::move(pointsLps)))
        && desk.apply(test::growBetween(TorsoVolume::lowerHu, TorsoVolume::upperHu));
}

bool makeBody(Desk& desk)
{
    constexpr double air = -500.0;
    return desk.apply(test::thresholdOf(1, air));
}

struct Shaped {
    const char* name;
    ShapeOperation operation;
};

/// @param segment "segment.large.liver."
QString measureAll(
    PeerReport& report, Desk& desk, const std::string& segment, const std::vector<Shaped>& all)
{
    for (const Shaped& each : all) {
        if (const QString why = measurePreview(
                report, desk, segment + each.name + ".picture", reshape(each.operation));
            !why.isEmpty())
            return why;
    }
    return measureWhole(report, desk, segment + "margin");
}

} // namespace

QString measureShapes(PeerReport& report)
{
    gpu::VolumeScene scene;
    scene.targetLps = TorsoVolume::liverLps();
    scene.eyeLps = scene.targetLps + glm::dvec3(-260.0, -430.0, 110.0);
    scene.heightMm = 450.0;
    scene.surfaceThreshold = 60000.0; // segments only
    const auto desk = Desk::open(TorsoVolume::make(slices), scene, TorsoVolume::liverLps());
    if (!desk || !desk->apply(test::newSegment(QStringLiteral("A"), 0x59C07A)))
        return QStringLiteral("segment.large: no room");
    if (!makeLiver(*desk))
        return QStringLiteral("segment.large.liver: not grown");
    if (const QString why = measureAll(report, *desk, "segment.large.liver.",
            {{"margin", ShapeOperation::Grow}, {"median", ShapeOperation::Median},
                {"gaussian", ShapeOperation::Gaussian}});
        !why.isEmpty())
        return why;
    if (!makeBody(*desk))
        return QStringLiteral("segment.large.body: no threshold");
    return measureAll(report, *desk, "segment.large.body.", {{"margin", ShapeOperation::Grow}});
}

} // namespace bench
