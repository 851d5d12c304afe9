// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/SeedTool.h"

#include "core/session/StepFindings.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/tools/growth/SeedMarks.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include "core/edits/kinds/growth/SeedStroke.h"
#include "ui/base/RowTitleText.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/LookingDirection.h"
#include "ui/tools/aim/SeenVoxels.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPointer>
#include <QToolButton>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace ui {

namespace {

constexpr double reachPixels = 7.0; ///< logical, from the pointer to a seed's dot

double pixelsToPath(const glm::dvec2& point, const std::vector<glm::dvec2>& path)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < path.size(); ++i) {
        const glm::dvec2& from = path[i == 0 ? 0 : i - 1];
        const glm::dvec2 along = path[i] - from;
        const double squared = glm::dot(along, along);
        const double t =
            squared > 0.0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::distance(point, from + t * along));
    }
    return nearest;
}

} // namespace

SeedTool::SeedTool(Workspace& workspace, QObject* parent)
    : SketchTool(workspace, parent)
{
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments)
                Q_EMIT overlayChanged();
        });
    connect(&workspace.seeds(), &PendingSeeds::changed, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &Tool::overlayChanged);
}

QString SeedTool::name() const
{
    return tr("Seed");
}

QString SeedTool::iconName() const
{
    return QStringLiteral("seed");
}

QString SeedTool::hint() const
{
    return tr(
        "Seed: sketch on what belongs to the segment, in a slice or on the 3D view; then grow");
}

QString SeedTool::target() const
{
    const core::EditSession* session = workspace().session();
    if (!session)
        return {};
    if (takesAway())
        return tr("takes seeds away");
    if (moves())
        return tr("moves a seed");
    const core::Segment* segment = session->document().segment(workspace().activeSegment());
    return segment ? tr("seeds for %1").arg(segment->name) : tr("seeds for a new segment");
}

QString SeedTool::keys() const
{
    return tr("Ctrl: takes seeds away · Shift: moves one · %1").arg(SketchTool::keys());
}

bool SeedTool::takesAway() const
{
    return drawing() && isInverse();
}

bool SeedTool::moves() const
{
    return drawing() && !takesAway() && modifiers().testFlag(Qt::ShiftModifier);
}

bool SeedTool::finishOtherwise(const std::vector<glm::dvec2>& pixels, const ViewContext& view)
{
    if (takesAway())
        takeAway(pixels, view);
    else if (moves())
        move(pixels.front(), pixels.back(), view);
    else
        return false;
    return true;
}

void SeedTool::takeAway(const std::vector<glm::dvec2>& pixels, const ViewContext& view)
{
    std::map<int, std::vector<glm::dvec3>> taken; // by segment
    for (const gpu::SceneSeed& seed : seedsShownIn(view, workspace())) {
        const QPointF at = view.toPixel(seed.lps);
        if (pixelsToPath({at.x(), at.y()}, pixels) <= std::max(reachPixels, widestPixels()))
            taken[seed.label].push_back(seed.lps);
    }
    if (taken.empty())
        workspace().say(tr("No seed was taken away: none that waits for a growth lies there"));
    for (const auto& [label, places] : taken)
        apply({.segment = label, .pointsLps = {}, .takenLps = places},
            places.size() == 1 ? tr("One seed was taken away")
                               : tr("%1 seeds were taken away").arg(places.size()));
}

void SeedTool::move(const glm::dvec2& from, const glm::dvec2& to, const ViewContext& view)
{
    const std::vector<gpu::SceneSeed> seeds = seedsShownIn(view, workspace());
    const auto distance = [&](const gpu::SceneSeed& seed) {
        const QPointF at = view.toPixel(seed.lps);
        return glm::distance(glm::dvec2(at.x(), at.y()), from);
    };
    const auto nearest = std::min_element(seeds.begin(), seeds.end(),
        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    if (nearest == seeds.end() || distance(*nearest) > reachPixels) {
        workspace().say(tr("No seed was moved: none that waits for a growth lies there"));
        return;
    }
    core::SeedStroke stroke{
        .segment = nearest->label, .pointsLps = {}, .takenLps = {{nearest->lps}}};
    const core::VolumeGeometry& geometry = workspace().volume()->geometry;
    if (view.isSlice()) {
        // Along the slice only: it stays in the layer of voxels that it was in.
        const glm::dvec3 lps =
            nearest->lps + view.toLps({to.x, to.y}) - view.toLps({from.x, from.y});
        const glm::ivec3 voxel(glm::round(geometry.toIndex(lps)));
        if (!geometry.contains(voxel)) {
            workspace().say(outsideText());
            return;
        }
        stroke.pointsLps = {geometry.toWorld(glm::dvec3(voxel))};
        workspace().seeds().noteSketch(stroke.segment, {voxel}, {});
        apply(stroke, tr("The seed was moved"));
        return;
    }
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    askWhatIsSeen(scene, {view.toViewPlaneMm({to.x, to.y})},
        [this, stroke, scene](const core::Result<SeenVoxels>& seen) {
            if (!seen)
                return workspace().fail(seen.error());
            if (seen->empty() || !seen->front())
                return workspace().say(nothingSeenText());
            const SeenVoxel& there = *seen->front();
            const core::VolumeGeometry& known = workspace().volume()->geometry;
            core::SeedStroke moved = stroke;
            moved.pointsLps = {known.toWorld(glm::dvec3(there.voxel))};
            SeenAlong along;
            if (const auto looking = lookingDirection(scene, there.piece, known))
                along.emplace_back(there.voxel, *looking);
            workspace().seeds().noteSketch(moved.segment, {there.voxel}, along);
            apply(moved, tr("The seed was moved"));
        });
}

void SeedTool::apply(const core::SeedStroke& stroke, const QString& done)
{
    core::EditSession& session = *workspace().session();
    if (const auto applied = session.apply(stroke); !applied) {
        workspace().fail(applied.error());
        return;
    }
    // Answered when the edit is carried out.
    session.questions().afterAll([tool = QPointer<SeedTool>(this), stroke, done] {
        if (tool)
            tool->reportSeeds(stroke, done);
    });
}

void SeedTool::reportSeeds(const core::SeedStroke& stroke, const QString& done)
{
    const core::EditSession& session = *workspace().session();
    const std::optional<core::SketchedSeeds>& seeds = session.findings().sketchedSeeds();
    if (!seeds || seeds->isPlain()) {
        workspace().say(done);
        return;
    }
    const core::Segment* segment = session.document().segment(stroke.segment);
    const QString name = segment ? segment->name : QString::number(stroke.segment);
    const QString why = textOf(core::whyNotTaken(*seeds, session.document()));
    if (seeds->taken > 0)
        workspace().say(tr("Seeds for %1: %2")
                            .arg(name, textOf(core::sketchedTitle(*seeds, session.document()))));
    else if (stroke.takenLps)
        workspace().say(tr("The seed of %1 was taken away, but not set anew: %2").arg(name, why));
    else
        workspace().say(tr("No seed was set for %1: %2").arg(name, why));
}

QWidget* SeedTool::createOptions(QWidget* parent)
{
    auto* options = new QWidget(parent);
    auto* row = new QHBoxLayout(options);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme::smallPadding);
    row->addWidget(new SeedOptions(workspace(), tr("Seeds for"), options));
    row->addWidget(widthButton(options));
    return options;
}

void SeedTool::commit(const std::vector<glm::ivec3>& voxels)
{
    const core::Result<int> label =
        segment() == 0 ? ensureActiveSegment(workspace()) : core::Result<int>(segment());
    if (!label) {
        workspace().fail(label.error());
        return;
    }
    workspace().seeds().noteSketch(*label, voxels, seenAlong());
    core::SeedStroke stroke;
    stroke.segment = *label;
    for (const glm::ivec3& voxel : voxels)
        stroke.pointsLps.push_back(workspace().volume()->geometry.toWorld(glm::dvec3(voxel)));
    const core::Document document = workspace().session()->foreseenDocument();
    const core::Segment* seeded = document.segment(*label); // it may be gone since it was sketched
    const QString name = seeded ? seeded->name : QString::number(*label);
    apply(stroke,
        voxels.size() == 1 ? tr("One seed voxel for %1").arg(name)
                           : tr("%1 seed voxels for %2").arg(voxels.size()).arg(name));
}

QColor SeedTool::colour() const
{
    if (takesAway())
        return theme::caution;
    const core::Document& document = workspace().session()->document();
    const core::Segment* segment = document.segment(workspace().activeSegment());
    return segment ? QColor(segment->rgb) : QColor(nextSegmentColour(document));
}

QString SeedTool::outsideText() const
{
    return tr("No seed was set: the sketch lies outside the volume");
}

QString SeedTool::nothingSeenText() const
{
    return tr("No seed was set: nothing is seen under the sketch");
}

void SeedTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (workspace().session() && view.isSlice())
        paintSeedMarks(painter, view, workspace());
    SketchTool::paintOverlay(painter, view);
}

} // namespace ui
