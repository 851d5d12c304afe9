// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/RandomHistory.h"

#include "core/base/Guarded.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditTask.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/pieces/SendPiecesHome.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/masks/MaskOnVolume.h"
#include "core/morphology/BetweenSlices.h"
#include "core/session/EditSession.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/cases/HistoryTruth.h"
#include "tests/support/cases/IslandTruth.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/GoldenSessions.h"

#include <QJsonDocument>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <random>

namespace test {

using namespace core;

namespace {

class HastyUser {
public:
    HastyUser(EditEngine& engine, std::uint32_t seed, const RandomDraws& draws)
        : m_engine(engine)
        , m_draws(draws)
        , m_random(seed)
        , m_truth(goldenStudy())
    {
        auto created = EditSession::create(
            m_engine, goldenStudy(), {.file = m_folder.filePath(QStringLiteral("s.burin"))});
        if (!created) {
            m_result.failure = QStringLiteral("no session");
            return;
        }
        m_session = *std::move(created);
        listen();
    }

    RandomHistory run(int commands, const std::function<void(bool)>& acting)
    {
        m_acting = acting;
        for (int step = 0; step < commands && m_result.failure.isEmpty(); ++step) {
            if (acting)
                acting(true);
            QString what = QStringLiteral("none");
            try {
                what = act();
            } catch (const std::bad_alloc&) { // in the user's own head
                ++m_result.refused[what];
            }
            if (m_session && m_isLost) {
                ++m_result.refused[QStringLiteral("lost")];
                reopen();
            }
            if (acting)
                acting(false);
            if (!m_session)
                break;
            takeRows();
            const RowId row = m_session->history().position();
            const QByteArray hash = m_session->stateHash();
            m_result.hashes.push_back(hash);
            QString difference = m_truth.difference(row, m_engine, m_session->document(), hash);
            if (difference.isEmpty())
                difference = followedAmiss(row);
            if (!difference.isEmpty())
                m_result.failure = QStringLiteral("step %1 (%2), row %3, %4: %5")
                                       .arg(step)
                                       .arg(what)
                                       .arg(row)
                                       .arg(editText(row), difference);
        }
        m_session.reset();
        return std::move(m_result);
    }

private:
    /// Of a row, as a recipe has it.
    [[nodiscard]] QString editText(RowId row) const
    {
        if (row == 0)
            return QStringLiteral("the beginning");
        return QString::fromUtf8(QJsonDocument(editToJson(m_session->history().row(row).edit))
                                     .toJson(QJsonDocument::Compact));
    }

    /// A segment that follows an interval has the voxels that the interval gave it.
    [[nodiscard]] QString followedAmiss(RowId row) const
    {
        for (const Segment& segment : m_session->document().segments) {
            if (segment.followsRow == 0)
                continue;
            const std::vector<std::uint8_t> given =
                m_truth.labelsAt(segment.followsRow, segment.plane);
            const std::vector<std::uint8_t> now = m_truth.labelsAt(row, segment.plane);
            for (std::size_t voxel = 0; voxel < now.size(); ++voxel) {
                if ((given[voxel] == segment.label) != (now[voxel] == segment.label))
                    return QStringLiteral("segment %1 follows row %2 and differs from it")
                        .arg(segment.label)
                        .arg(segment.followsRow);
            }
        }
        return {};
    }

    /// How the name of a row ends that only has criteria for later growths.
    static constexpr QLatin1String noVoxel{", no voxel"};
    /// How edits of segments beyond the first plane are counted in addition.
    static constexpr QLatin1String inPlanes{", further plane"};

    int between(int low, int high) { return low + int(m_random() % std::uint32_t(high - low + 1)); }
    bool chance(int percent) { return between(1, 100) <= percent; }
    template <class T> const T& any(const std::vector<T>& list)
    {
        return list[std::size_t(between(0, int(list.size()) - 1))];
    }

    QString act()
    {
        // What was undone is redone more often than not.
        if (m_session->history().canRedo() && chance(25))
            return note(QStringLiteral("redo"), m_session->redo());
        const int dice = between(0, 99);
        if (dice < 18)
            return note(QStringLiteral("undo"), m_session->undo());
        if (dice < 24)
            return jump();
        if (dice < 26)
            return reopen();
        if (dice < 31)
            return giveUp();
        // Of a few thoughts the one that came true least, so that no kind is left to luck.
        Edit edit = think();
        for (int i = 0; i < 3; ++i) {
            Edit other = think();
            if (m_result.done[kindOf(other)] < m_result.done[kindOf(edit)])
                edit = std::move(other);
        }
        std::optional<EditableRange>* const range =
            m_draws.limited ? editableRangeOf(edit) : nullptr;
        const GrowCriteria* const criteria = growCriteriaOf(edit);
        const auto* const sharing = edit.as<GrowFromSeeds>();
        // Most ranges leave a growth nothing.
        const bool isLimited = range && chance(criteria ? 25 : 70);
        std::optional<std::uint8_t> plane;
        if (criteria || sharing)
            plane = growthPlaneOf(criteria ? criteria->plane : sharing->plane);
        if (isLimited)
            *range = randomRange(plane);
        const std::size_t rows = m_session->history().rows().size();
        const bool inFurtherPlane = isInFurtherPlane(edit);
        const QString kind = note(kindOf(edit), m_session->apply(edit), rows);
        const bool isRow = m_session->history().rows().size() > rows;
        if (isLimited && isRow)
            ++m_result.done[QStringLiteral("editable")];
        const auto* growth = edit.as<GrowSteps>();
        if (isRow && growth && growth->criteria.smoothing.value_or(false))
            ++m_result.done[QStringLiteral("smoothed")];
        const auto* filling = edit.as<FillBetweenSlices>();
        if (isRow && filling && filling->planes)
            ++m_result.done[QStringLiteral("between planes")];
        if (isRow && inFurtherPlane)
            ++m_result.done[kind + inPlanes];
        const bool counted = edit.is<Annotate>() || edit.is<MoveMeasurement>();
        if (counted && m_session->history().rows().size() > rows)
            ++m_result.done[editName(edit)];
        return kind;
    }

    /// Whether it writes to a segment of a plane beyond the first, or makes one.
    [[nodiscard]] bool isInFurtherPlane(const Edit& edit) const
    {
        const auto isFurther = [this](int label) {
            const Segment* segment = m_session->document().segment(label);
            return segment && segment->plane > 0;
        };
        if (const auto* add = edit.as<AddSegment>())
            return add->plane.value_or(0) > 0;
        if (const auto* copy = edit.as<CopySegment>())
            return copy->plane != 0;
        if (const auto* mask = edit.as<ImportMask>(); mask && mask->planes)
            return std::any_of(
                mask->planes->begin(), mask->planes->end(), [](int plane) { return plane > 0; });
        if (const auto* remove = edit.as<RemoveSegment>())
            return isFurther(remove->segment);
        if (const auto* toLayer = edit.as<SegmentToLayer>())
            return isFurther(toLayer->segment);
        if (const auto* seeds = edit.as<SeedStroke>())
            return isFurther(seeds->segment);
        if (const auto* barrier = edit.as<BarrierStroke>())
            return growthPlaneOf(barrier->plane) > 0;
        if (const auto* spread = edit.as<GrowFromSeeds>())
            return growthPlaneOf(spread->plane) > 0;
        if (const std::optional<std::uint8_t> grown = effectsOf(edit).movesGenerationOf)
            return *grown > 0;
        return isFurther(effectsOf(edit).writesTo.value_or(0));
    }
    /// Under which name it is counted.
    static QString kindOf(const Edit& edit)
    {
        static constexpr std::array<const char*, 6> rules{" fill holes", " keep largest",
            " remove small", " keep clicked", " remove clicked", " give clicked"};
        if (const auto* clean = edit.as<CleanSegment>())
            return editName(edit) + QLatin1String(rules[std::size_t(clean->rule)]);
        static constexpr std::array<const char*, 5> hows{
            " merge", " swap", " union", " subtract", " intersect"};
        if (const auto* both = edit.as<CombineSegments>())
            return editName(edit) + QLatin1String(hows[std::size_t(both->how)]);
        // What stands in its place does not change what comes to be drawn next.
        if (edit.is<Annotate>() || edit.is<MoveMeasurement>())
            return editName(AddMeasurement());
        return editName(edit);
    }

    /// @param rowsBefore an edit leaves a row, or did nothing
    QString note(
        const QString& what, Result<void> result, std::optional<std::size_t> rowsBefore = {})
    {
        const Result<void> settled = m_session->settle();
        if (result && !settled)
            result = settled;
        const std::size_t rows = m_session->history().rows().size();
        if (!result)
            ++m_result.refused[what];
        if (!result)
            return what;
        if (!rowsBefore)
            ++m_result.done[what];
        else if (rows > *rowsBefore)
            ++m_result
                  .done[m_session->history().rows().back().name.contains(noVoxel) ? what + noVoxel
                                                                                  : what];
        return what;
    }
    /// Whether nothing more can be done but opening it again.
    void listen()
    {
        m_isLost = false;
        m_session->setErrorListener([this](const Error& error) {
            m_isLost = m_isLost || error.code == ErrorCode::EngineLost
                || error.arguments.value(0).contains(QLatin1String("open it again"));
        });
    }
    QString jump()
    {
        const auto rows = int(m_session->history().rows().size());
        return note(QStringLiteral("goTo"), m_session->goTo(between(0, rows)));
    }
    QString reopen()
    {
        m_session.reset();
        const QString file = m_folder.filePath(QStringLiteral("s.burin"));
        const auto open = [&] {
            return guarded([&] { return EditSession::open(m_engine, goldenStudy(), file); });
        };
        auto opened = open();
        for (int again = 0; again < 5 && !opened; ++again) {
            if (opened.error().code != ErrorCode::OutOfMemory)
                break;
            ++m_result.refused[QStringLiteral("reopen")];
            opened = open();
        }
        // Who is refused again and again tries once more when there is memory.
        if (!opened && opened.error().code == ErrorCode::OutOfMemory && m_acting) {
            m_acting(false);
            opened = open();
            m_acting(true);
        }
        if (opened) {
            m_session = *std::move(opened);
            listen();
        } else {
            m_result.failure =
                QStringLiteral("not opened again: ") + opened.error().arguments.join(u' ');
        }
        ++m_result.done[QStringLiteral("reopen")];
        return QStringLiteral("reopen");
    }
    /// A stroke or a growth under way that is given up leaves nothing.
    QString giveUp()
    {
        const std::size_t rows = m_session->history().rows().size();
        Edit edit = randomGrowth();
        if (chance(30)) {
            BrushStroke stroke = randomBrush();
            const std::vector<glm::dvec3> points = stroke.path.pointsLps;
            stroke.path.pointsLps.resize(1);
            if (stroke.path.pressures)
                stroke.path.pressures->resize(1);
            if (m_session->begin(stroke))
                m_session->extend(PathPoints{.pointsLps = points});
        } else if (chance(50)) {
            DrillStroke stroke = randomDrill();
            const std::vector<PenSample> samples = std::exchange(stroke.samples, {});
            if (m_session->begin(stroke))
                m_session->extend(PenSamples{.samples = samples});
        } else if (m_session->begin(edit)) {
            m_session->extend(GrowAdvance{.steps = 2});
        }
        m_session->poll();
        m_session->end(Ending::Rollback);
        static_cast<void>(m_session->settle());
        if (m_session->history().rows().size() != rows)
            m_result.failure = QStringLiteral("a stroke that was given up left a row");
        ++m_result.done[QStringLiteral("given up")];
        return QStringLiteral("given up");
    }

    Edit think()
    {
        const Document& document = m_session->document();
        const std::vector<RowId> rows = m_truth.standingAt(m_session->history().position());
        if (m_draws.planes && wantsImport(document))
            return randomImport(document);
        if (m_draws.planes && document.labelPlanes().size() > 1 && chance(25))
            return randomGrowthInAPlane(document);
        if (m_draws.smoothed && !document.segments.empty() && chance(20)) {
            if (chance(50))
                return randomGrowth();
            return randomSeeds(any(document.segments).label);
        }
        const int dice = document.segments.empty() ? 0 : between(0, 99);
        if (dice < 5 && document.segments.size() < 6)
            return randomAddition();
        if (dice < 15)
            return randomChange(document);
        if (dice < 17)
            return MoveSegment{.segment = any(document.segments).label, .place = between(1, 6)};
        if (dice < 20)
            return RemoveSegment{.segment = any(document.segments).label};
        if (dice < 28)
            return randomLayer(document);
        if (dice < 32)
            return randomBookmark(document);
        if (dice < 38)
            return randomPassage(document);
        if (dice < 44)
            return randomPiece(document);
        if (dice < 51)
            return randomSeeds(any(document.segments).label);
        if (dice < 55)
            return randomGrowth();
        if (dice < 68)
            return randomSteering();
        if (dice < 72)
            return randomPaint(any(document.segments).label);
        if (dice < 75)
            return randomBrush();
        if (dice < 78 || rows.empty())
            return randomDrill();
        if (dice < 80)
            return randomLaser();
        if (dice < 82)
            return randomOutlined();
        if (dice < 87)
            return ReviseStroke(randomRevision(rows));
        if (dice < 92)
            return randomWhole(document);
        return randomRevert(rows);
    }

    Edit randomAddition()
    {
        AddSegment add{.name = randomName(), .rgb = std::uint32_t(m_random()) & 0xFFFFFFu};
        add.plane = anyPlane();
        return add;
    }

    /// Soon where nothing lies in a further plane, now and then else.
    bool wantsImport(const Document& document)
    {
        const bool hasPlanes = document.labelPlanes().size() > 1;
        return document.segments.size() < 8 && chance(hasPlanes ? 5 : 50);
    }
    /// Boxes that overlap, as if read from a file: in the planes that they need or in any, or all
    /// for a segment that is there.
    ImportMask randomImport(const Document& document)
    {
        const glm::ivec3 size = document.volumes.front().geometry.size;
        std::vector<MaskSegment> masks;
        const glm::ivec3 middle{
            between(8, size.x - 9), between(8, size.y - 9), between(8, size.z - 9)};
        for (int i = between(2, 3); i > 0; --i) {
            const glm::ivec3 from =
                middle - glm::ivec3{between(1, 8), between(1, 8), between(1, 8)};
            const glm::ivec3 to = middle + glm::ivec3{between(1, 8), between(1, 8), between(1, 8)};
            masks.push_back({.name = randomName(),
                .rgb = {},
                .code = {},
                .voxels = runsOfBox({from, to}, size)});
        }
        ImportMask mask{.file = QStringLiteral("organs.seg.nrrd")};
        mask.size = size;
        mask.segments.emplace();
        for (const MaskSegment& each : masks)
            mask.segments->push_back({.name = each.name,
                .rgb = std::uint32_t(m_random()) & 0xFFFFFFu,
                .code = {},
                .voxels = packedRuns(each.voxels)});
        mask.overwriteUnlocked = chance(40);
        if (chance(30))
            mask.ahead = std::vector<int>{between(1, int(masks.size()))};
        if (!document.segments.empty() && chance(25)) {
            mask.as = SegmentWord{.number = any(document.segments).label, .name = {}};
            return mask;
        }
        mask.planes = planesFor(overlapsOf(masks), masks.size());
        if (chance(30)) {
            for (int& plane : *mask.planes)
                plane = between(0, mostLabelPlanes - 1);
        }
        return mask;
    }
    /// The labels of the plane in which a segment lies, as they are now.
    [[nodiscard]] std::vector<std::uint8_t> labelsBeside(int segment) const
    {
        return m_truth.labelsAt(
            m_session->history().position(), m_session->document().segment(segment)->plane);
    }

    /// @param plane in which the segments lie that it lists; none: in any
    EditableRange randomRange(std::optional<std::uint8_t> plane)
    {
        const Document& document = m_session->document();
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        const auto voxel = [&] {
            return geometry.toWorld({between(0, geometry.size.x - 1),
                between(0, geometry.size.y - 1), between(0, geometry.size.z - 1)});
        };
        const auto some = [&](int percent) {
            std::vector<int> segments;
            for (const Segment& segment : document.segments) {
                if (chance(percent) && segment.plane == plane.value_or(segment.plane))
                    segments.push_back(segment.label);
            }
            std::sort(segments.begin(), segments.end());
            return segments;
        };
        EditableRange range;
        if (chance(40))
            range.lower = between(-1200, 60);
        if (chance(40))
            range.upper = between(0, 1200) + 60;
        if (chance(30))
            range.box = GrowBox{voxel(), voxel()};
        if (chance(30))
            range.inside = some(70);
        if (chance(30))
            range.outside = some(40);
        return range;
    }
    QString randomName() { return QStringLiteral("Name %1").arg(between(1, 9)); }
    Edit randomChange(const Document& document)
    {
        ChangeSegment change{.segment = any(document.segments).label};
        switch (between(0, 4)) {
        case 0:
            change.name = randomName();
            break;
        case 1:
            change.rgb = std::uint32_t(m_random()) & 0xFFFFFFu;
            break;
        case 2:
            change.code = chance(50) ? CodedConcept{QStringLiteral("SCT"),
                              QStringLiteral("89546000"), QStringLiteral("Skull")}
                                     : CodedConcept{};
            break;
        case 3:
            change.uncarvable = chance(60);
            break;
        default:
            change.locked = chance(40);
        }
        return change;
    }
    Edit randomLayer(const Document& document)
    {
        const SculptLayer& layer = any(document.layers);
        const bool room = document.lastLayerGiven() < 8;
        if (room && (document.layers.size() < 2 || (document.layers.size() < 3 && chance(30))))
            return AddLayer{.name = randomName()};
        if (chance(10))
            return RemoveLayer{.layer = layer.id};
        if (chance(15))
            return MergeLayers{.from = layer.id, .into = any(document.layers).id};
        if (chance(20))
            return ChangeLayer{.layer = layer.id, .solo = !layer.solo};
        if (chance(25))
            return MoveLayer{.layer = layer.id, .place = between(1, 3)};
        if (chance(25))
            return ChangeLayer{.layer = layer.id, .name = randomName()};
        return ChangeLayer{.layer = layer.id, .muted = !layer.muted};
    }
    /// Between layers and segments.
    Edit randomPassage(const Document& document)
    {
        // Of the row's number, as in randomGrowth().
        if (m_session->history().rows().size() % 32 == 0)
            return InvertSegment{.segment = document.segments.front().label};
        if (m_session->history().rows().size() % 8 == 3)
            return randomOutline(any(document.segments).label);
        if (m_session->history().rows().size() % 8 == 5)
            return randomReshape(document);
        if (m_session->history().rows().size() % 8 == 1
            || (m_draws.crossing && m_session->history().rows().size() % 2 == 0)) {
            if (const std::optional<FillBetweenSlices> filling = randomBetween(document))
                return *filling;
        }
        if (m_session->history().rows().size() % 8 == 7)
            return randomFlood(document);
        if (m_session->history().rows().size() % 16 == 2)
            return randomThreshold(document);
        if (m_session->history().rows().size() % 16 == 6)
            return randomSnip(document);
        if (m_session->history().rows().size() % 16 == 10)
            return randomMirror(document);
        if (m_session->history().rows().size() % 16 == 14)
            return randomContour(document);
        if (m_session->history().rows().size() % 32 == 4) {
            if (const std::optional<SplitIslands> split = randomIslands(document))
                return *split;
        }
        if (m_session->history().rows().size() % 64 == (m_draws.limited ? 20 : 52)
            && document.segments.size() < 7)
            return randomCurveSplit(document);
        if (m_session->history().rows().size() % 32 == 20 && document.segments.size() < 7)
            return randomSplit(document);
        SegmentChoice target{.segment = any(document.segments).label};
        if (document.segments.size() < 6 && chance(30))
            target = {.name = randomName(), .rgb = std::uint32_t(m_random()) & 0xFFFFFFu};
        switch (between(0, 2)) {
        case 0:
            return LayerToSegment{.layer = any(document.layers).id,
                .target = target,
                .overwriteUnlocked = chance(40)};
        case 1:
            return SegmentToLayer{
                .segment = any(document.segments).label, .layer = any(document.layers).id};
        default:
            break;
        }
        SegmentSeen seen{.target = target};
        if (chance(70))
            seen.lower = between(-200, 500);
        if (chance(30))
            seen.upper = between(0, 1200);
        seen.overwriteUnlocked = chance(40);
        std::vector<ClipHalfSpace> sides;
        for (int i = between(0, 2); i > 0; --i)
            sides.push_back(beyond(randomDrill().view.targetLps,
                glm::dvec3{between(-10, 10), between(1, 10), between(-10, 10)}));
        if (!sides.empty())
            seen.hidden = sides;
        return seen;
    }
    /// What is done to all of a segment; some are refused, since what they name is locked, is the
    /// segment itself, or lies where nothing of it is.
    Edit randomWhole(const Document& document)
    {
        const int segment = any(document.segments).label;
        const int other = any(document.segments).label;
        if (m_draws.planes && document.labelPlanes().size() > 1 && chance(40))
            return CombineSegments{
                .segment = segment, .with = other, .how = CombineSegments::How(between(2, 4))};
        if (m_draws.planes && document.segments.size() < 8 && chance(40))
            return randomCopy(segment);
        if (chance(30))
            return CombineSegments{.segment = segment,
                .with = other,
                .how = chance(50) ? CombineSegments::How::Swap : CombineSegments::How::Merge};
        CleanSegment clean{.segment = segment, .rule = IslandRule(between(0, 5))};
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        const std::vector<std::uint8_t> labels = labelsBeside(segment);
        if (clean.rule == IslandRule::FillHoles)
            clean.segment = holedSegment().value_or(segment);
        // Never as much as a whole number of voxels: rounding decides nothing.
        const glm::dvec3 spacing = geometry.spacingMm();
        const double limit = between(1, 80) - 0.5;
        if (clean.rule == IslandRule::RemoveSmall
            || (clean.rule == IslandRule::FillHoles && chance(30)))
            clean.mm3 = limit * spacing.x * spacing.y * spacing.z;
        if (!isOfClicked(clean.rule))
            return clean;
        if (clean.rule == IslandRule::GiveClicked)
            clean.to = other;
        std::vector<std::size_t> own;
        for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
            if (labels[voxel] == segment)
                own.push_back(voxel);
        }
        const bool hits = !own.empty() && chance(90);
        const std::size_t voxel = hits ? any(own) : labels.size() / 2;
        const auto columns = std::size_t(geometry.size.x);
        const auto rows = std::size_t(geometry.size.y);
        clean.islandLps = geometry.toWorld(
            glm::dvec3(voxel % columns, voxel / columns % rows, voxel / columns / rows));
        return clean;
    }
    /// Sometimes in a plane that is named, where others may have some of its voxels, or none.
    CopySegment randomCopy(int segment)
    {
        CopySegment copy{
            .segment = segment, .name = randomName(), .rgb = std::uint32_t(m_random()) & 0xFFFFFFu};
        if (chance(30))
            copy.plane = between(0, mostLabelPlanes - 1);
        return copy;
    }
    /// One that has a hole of which a part is nobody's.
    [[nodiscard]] std::optional<int> holedSegment() const
    {
        const Document& document = m_session->document();
        for (const Segment& segment : document.segments) {
            const std::vector<std::uint8_t> labels = labelsBeside(segment.label);
            const std::vector<bool> holes =
                islandVoxels({.segment = segment.label}, document.volumes.front().geometry, labels);
            for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
                if (holes[voxel] && labels[voxel] == 0 && !segment.locked)
                    return segment.label;
            }
        }
        return std::nullopt;
    }
    /// Something else than a distance at its places; no die is cast, so that which is drawn next
    /// does not depend on it.
    static Edit annotated(const AddMeasurement& measured, Measurement::Kind kind)
    {
        using Kind = Measurement::Kind;
        const glm::dvec3 from = measured.fromLps;
        Annotate edit{.kind = kind, .pointsLps = {from}, .piece = measured.piece};
        if (kind == Kind::Angle)
            edit.pointsLps = {measured.toLps, from, from + glm::dvec3(1.0, 2.0, 3.0)};
        else if (kind == Kind::Ellipse || kind == Kind::Rectangle)
            edit.pointsLps = {from, from + glm::dvec3(7.0, 0.0, 0.0), from + glm::dvec3(0, 3, 1)};
        else if (kind == Kind::Outline)
            edit.pointsLps = {from, from + glm::dvec3(9.0, 0.0, 0.0), from + glm::dvec3(9, 5, 0),
                from + glm::dvec3(2.0, 8.0, 0.0)};
        else if (kind == Kind::Ball || kind == Kind::Arrow)
            edit.pointsLps = {from, measured.toLps};
        if (kind == Kind::Text || (kind == Kind::Arrow && from.x > 0.0))
            edit.text = QStringLiteral("here");
        if (kind == Kind::Angle && from.y > 0.0)
            edit.projected = true;
        return edit;
    }
    static Edit moved(const Measurement& measurement)
    {
        MoveMeasurement move{.measurement = measurement.id, .pointsLps = measurement.pointsLps};
        for (glm::dvec3& point : move.pointsLps)
            point += glm::dvec3(0.5, -1.0, 2.0);
        return move;
    }
    /// Views, distances and notes that are kept.
    Edit randomBookmark(const Document& document)
    {
        if (!document.bookmarks.empty() && chance(50))
            return RemoveBookmark{.bookmark = any(document.bookmarks).id};
        if (!document.measurements.empty() && chance(30))
            return RemoveMeasurement{.measurement = any(document.measurements).id};
        if (chance(50)) {
            AddMeasurement measured{.fromLps = randomDrill().view.targetLps,
                .toLps = glm::dvec3(between(-20, 20), 0.5, 120.0)};
            if (!document.pieces.empty() && chance(50))
                measured.piece = any(document.pieces).id;
            // Now and then one that is there is moved instead.
            if (!document.measurements.empty() && int(measured.toLps.x) % 2 == 0)
                return moved(document.measurements.back());
            const int given = document.lastMeasurementGiven();
            if (given % 2 == 0)
                return measured;
            return annotated(measured, Measurement::Kind(1 + given / 2 % 8));
        }
        return AddBookmark{.name = randomName(),
            .view = randomDrill().view,
            .crosshairLps = glm::dvec3(between(-20, 20), 0.5, 120.0)};
    }
    Edit randomPiece(const Document& document)
    {
        const auto turn = [this] { return glm::dvec3{between(-90, 90), between(-90, 90), 12.5}; };
        const auto away = [this] { return glm::dvec3{between(-40, 40), 3.25, between(-9, 9)}; };
        const int dice = document.pieces.empty() ? between(0, 29) : between(0, 99);
        if (dice < 15)
            return CutPiece{.layer = any(document.layers).id, .name = randomName()};
        if (dice < 30)
            return PastePiece{.segment = any(document.segments).label,
                .name = randomName(),
                .pivotLps = away(),
                .pose = {.offsetMm = away(), .zoom = between(1, 9) / 2.0}};
        const int piece = any(document.pieces).id;
        if (dice < 40)
            return RemovePiece{.piece = piece};
        if (dice < 62)
            return SendPiecesHome{};
        if (dice < 66)
            return ChangePiece{.piece = piece, .name = randomName()};
        return ChangePiece{.piece = piece, .offsetMm = away(), .rotationDegrees = turn()};
    }
    Edit randomSeeds(int segment)
    {
        const VolumeGeometry& geometry = m_session->document().volumes.front().geometry;
        SeedStroke stroke{.segment = segment, .pointsLps = {}};
        for (int i = between(1, 4); i > 0; --i) {
            const glm::dvec3 voxel{between(0, geometry.size.x - 1), between(0, geometry.size.y - 1),
                between(0, geometry.size.z - 1)};
            stroke.pointsLps.push_back(geometry.toWorld(voxel));
        }
        if (chance(20))
            stroke.pointsLps.back() = smallBall(-1.0);
        if (chance(30) && !m_sketched.empty())
            stroke.takenLps = {any(m_sketched), any(m_sketched)};
        if (stroke.takenLps && chance(30))
            stroke.pointsLps.clear();
        m_sketched.insert(m_sketched.end(), stroke.pointsLps.begin(), stroke.pointsLps.end());
        return stroke;
    }
    /// The middle of one of the two balls with a neck between them. @param side −1 or 1
    [[nodiscard]] glm::dvec3 smallBall(double side) const
    {
        const VolumeGeometry& geometry = m_session->document().volumes.front().geometry;
        return geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0)
            + glm::dvec3(10.0 * side, 0.0, 20.0);
    }
    GrowSteps randomGrowth()
    {
        GrowSteps grow = (chance(50) ? growBrain() : growBone()).get<GrowSteps>();
        if (chance(20)) { // what may leak through the tube between the two small balls
            grow.criteria.lower = 250;
            grow.criteria.upper = 350;
        } else if (chance(15))
            grow.criteria.lower = -1000; // through everything up to its upper bound
        if (chance(75))
            grow.steps = between(1, 4);
        grow.criteria.overwriteUnlocked = chance(30);
        grow.criteria.onlyVisible = chance(15);
        if (chance(20))
            grow.criteria.connectivity = chance(50) ? 18 : 26;
        if (chance(15))
            grow.criteria.difference = between(20, 200);
        if (chance(10))
            grow.criteria.sigmas = between(10, 40) / 10.0;
        if (chance(15))
            grow.guard.factor = between(10, 40) / 10.0;
        // Of the row's number: the histories of before stay as they are but for this.
        const std::size_t row = m_session->history().rows().size();
        if (grow.criteria.sigmas && row % 2 == 0)
            grow.criteria.perStroke = true;
        if (row % 7 == 0)
            grow.criteria.passage = 1.5 + double(row % 10) / 2.0;
        if (m_draws.smoothed)
            grow.criteria.smoothing = chance(80);
        grow.criteria.plane = anyPlane();
        return grow;
    }
    /// A plane of a growth, of those in which segments lie, now and then one in which none does.
    /// The first one is mostly not named.
    std::optional<int> anyPlane()
    {
        if (!m_draws.planes)
            return std::nullopt;
        const std::vector<std::uint8_t> planes = m_session->document().labelPlanes();
        const int plane = chance(3) ? mostLabelPlanes - 1
            : chance(50)            ? int(planes.back())
                                    : int(any(planes));
        return plane == 0 && chance(80) ? std::nullopt : std::optional(plane);
    }
    /// Growths of segments beyond the first plane, which would be rare else.
    Edit randomGrowthInAPlane(const Document& document)
    {
        const int dice = between(0, 99);
        if (dice < 30)
            return randomGrowth();
        if (dice < 60)
            return randomSteering();
        std::vector<int> further;
        for (const Segment& segment : document.segments) {
            if (segment.plane > 0)
                further.push_back(segment.label);
        }
        if (dice < 70) {
            PaintStroke paint = randomPaint(any(further));
            paint.seeds = true;
            return paint;
        }
        return randomSeeds(any(further));
    }
    /// What is done to a growth that is there.
    Edit randomSteering()
    {
        const std::optional<int> plane = anyPlane();
        if (m_truth.grownVoxels(m_session->history().position(), plane.value_or(0)).empty())
            return chance(50) ? Edit(randomSeeds(any(m_session->document().segments).label))
                              : Edit(randomGrowth());
        switch (between(0, 10)) {
        case 0:
            return chance(30) ? ShrinkSteps{.plane = plane}
                              : ShrinkSteps{.steps = between(1, 4), .plane = plane};
        case 1: {
            ShrinkAt shrink{
                .pointsLps = grownPlaces(plane), .onlyHere = chance(30), .barrier = chance(70)};
            shrink.plane = plane;
            // Of the row's number, as for growths.
            const std::size_t row = m_session->history().rows().size();
            if (!shrink.onlyHere && row % 3 == 0)
                shrink.steps = 1 + int(row % 5);
            return shrink;
        }
        case 2:
        case 6:
        case 7:
            return PlugLeak{.pointLps = chance(50) ? smallBall(1.0) : grownPlaces(plane).back(),
                .plane = plane};
        case 3:
            return BarrierStroke{.path = randomPath(), .erase = chance(30), .plane = plane};
        case 4: {
            ChangeInterval change;
            change.criteria.lower = between(-1000, 400);
            change.criteria.upper = between(100, 2000);
            change.criteria.plane = plane;
            if (chance(40))
                change.steps = between(0, 4);
            if (m_session->history().rows().size() % 4 == 0)
                change.guard.factor = 1.5;
            return change;
        }
        case 5: {
            ResumeGrowth resume{.plane = plane};
            if (chance(60))
                resume.steps = between(1, 4);
            return resume;
        }
        default:
            return GrowFromSeeds{.connectivity = chance(50) ? 6 : 26,
                .overwriteUnlocked = chance(30),
                .plane = plane};
        }
    }
    /// Voxels that growths of a plane have added; any where there are none.
    std::vector<glm::dvec3> grownPlaces(const std::optional<int>& plane)
    {
        std::vector<glm::ivec3> held =
            m_truth.grownVoxels(m_session->history().position(), plane.value_or(0));
        const VolumeGeometry& geometry = m_session->document().volumes.front().geometry;
        std::vector<glm::dvec3> places;
        for (int i = between(1, 3); i > 0; --i)
            places.push_back(
                geometry.toWorld(glm::dvec3(held.empty() ? glm::ivec3(1) : any(held))));
        return places;
    }
    DrillStroke randomDrill()
    {
        DrillStroke stroke = drillAt(between(-120, 120) / 10.0).get<DrillStroke>();
        const glm::dvec3 middle = stroke.view.targetLps;
        if (chance(40)) // from another side
            stroke.view.eyeLps = middle + glm::dvec3{between(-200, 200), between(50, 200), 30};
        for (PenSample& sample : stroke.samples)
            sample.yMm += between(-60, 60) / 10.0;
        stroke.mask.radiusMm = between(10, 70) / 10.0;
        stroke.depthMm = between(10, 90) / 10.0;
        stroke.layer = any(m_session->document().layers).id;
        stroke.throughGaps = chance(30);
        stroke.restore = chance(30);
        if (chance(40)) {
            stroke.mask.kind = ToolMask::Kind(between(0, 4));
            stroke.mask.widthMm = between(10, 140) / 10.0;
            stroke.mask.heightMm = between(10, 140) / 10.0;
            stroke.mask.rotationDegrees = between(0, 90);
        }
        if (chance(20))
            stroke.mask.polygonMm = {{{-6, -4}, {5, between(-50, 50) / 10.0}, {-3, 6}, {7, 7}}};
        if (chance(25)) {
            stroke.mode = DrillMode::Rate;
            stroke.depthMm *= 10.0;
            stroke.floorMm = between(10, 90) / 10.0;
        }
        stroke.byTime = chance(50);
        if (chance(30))
            stroke.guardMm = between(1, 40) / 10.0;
        if (chance(20)) // what lies before a plane through about the surface
            stroke.hidden = {{{glm::normalize(stroke.view.eyeLps - middle), 0.0}}};
        if (stroke.hidden)
            stroke.hidden->front().offsetMm =
                glm::dot(stroke.hidden->front().normalLps, middle) + between(0, 60) / 2.0;
        return stroke;
    }
    LaserStroke randomLaser()
    {
        const DrillStroke drill = randomDrill();
        LaserStroke laser{.layer = drill.layer, .view = drill.view, .mask = drill.mask};
        laser.mode = drill.mode;
        laser.depthMm = drill.depthMm;
        laser.floorMm = drill.floorMm;
        laser.surfaceThreshold = drill.surfaceThreshold;
        laser.throughGaps = drill.throughGaps;
        laser.restore = drill.restore;
        laser.byTime = drill.byTime;
        laser.samples = drill.samples;
        laser.hidden = drill.hidden;
        return laser;
    }
    /// From a place that drills reach; on one slice now and then.
    BrushPath randomPath()
    {
        BrushPath path{.radiusMm = between(5, 60) / 10.0};
        const DrillStroke drill = randomDrill();
        glm::dvec3 at = drill.view.targetLps
            + glm::dvec3(drill.samples.front().xMm, -between(6, 15), drill.samples.front().yMm);
        for (int i = between(1, 4); i > 0; --i) {
            at += glm::dvec3{between(-60, 60), between(-60, 60), between(-30, 30)} / 10.0;
            path.pointsLps.push_back(at);
        }
        if (chance(40)) {
            path.shape = BrushPath::Shape::Disc;
            path.normalLps = glm::dvec3(0, 0, 1);
        }
        // Of the row's number, as in randomGrowth().
        if (m_session->history().rows().size() % 3 == 0) {
            path.pressures.emplace(path.pointsLps.size(), 0.4);
            path.pressures->front() = 1.0;
        }
        if (m_session->history().rows().size() % 5 == 2) {
            path.shape = path.normalLps ? BrushPath::Shape::Square : BrushPath::Shape::Cube;
            path.normalLps = glm::dvec3(0, 0, 1);
            path.sideLps = glm::dvec3(1, 0.5, 0);
        }
        return path;
    }
    /// In a slice along the grid or an oblique one, of a curve that may cross itself.
    FillOutline randomOutline(int segment)
    {
        FillOutline outline{.segment = segment, .originLps = randomPath().pointsLps.front()};
        if (chance(50))
            outline.upLps = {0.1, 0.6, between(-8, 8) / 10.0};
        for (int i = between(3, 5); i > 0; --i)
            outline.polygonMm.emplace_back(between(-80, 80) / 10.0, between(-80, 80) / 10.0);
        outline.erase = chance(30);
        outline.overwriteUnlocked = chance(40);
        if (chance(30))
            outline.lower = between(-200, 300);
        return outline;
    }
    /// Of one that has islands, with a smallest size or without, into one or two segments more.
    std::optional<SplitIslands> randomIslands(const Document& document)
    {
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        const std::size_t before = std::size_t(between(0, int(document.segments.size()) - 1));
        const auto others = std::size_t(between(1, 2));
        const bool isNamed = chance(40);
        for (std::size_t i = 0; i < document.segments.size() && document.segments.size() < 7; ++i) {
            const Segment& segment = document.segments[(before + i) % document.segments.size()];
            const auto islands =
                islandsBySize(geometry.size, labelsBeside(segment.label), segment.label);
            if (islands.size() < 2 || segment.locked)
                continue;
            SplitIslands split{.segment = segment.label};
            const std::size_t last = std::min(others, islands.size() - 1);
            // Never as much as a whole number of voxels: rounding decides nothing. Where the next
            // one is as large, it would be a segment more.
            const glm::dvec3 spacing = geometry.spacingMm();
            const bool isNextSmaller =
                last + 1 == islands.size() || islands[last + 1].size() < islands[last].size();
            if (isNextSmaller)
                split.mm3 =
                    (double(islands[last].size()) - 0.5) * spacing.x * spacing.y * spacing.z;
            if (isNamed || !isNextSmaller)
                split.into = std::vector(last, SplitPart{.name = randomName(), .rgb = 0x708090});
            return split;
        }
        return std::nullopt;
    }
    /// Through a voxel of it, if it has any.
    SplitSegment randomSplit(const Document& document)
    {
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        SplitSegment split{.segment = any(document.segments).label};
        const int right = between(-9, 9);
        const int back = between(-9, 9);
        split.normalLps = {right, back, between(1, 9)};
        split.into = {.name = randomName(), .rgb = 0x907080};
        split.placeLps = geometry.toWorld(glm::dvec3(voxelOf(split.segment, geometry.size)));
        return split;
    }
    /// One of a segment, or the middle one of the volume if it has none.
    glm::ivec3 voxelOf(int segment, const glm::ivec3& size)
    {
        const std::vector<std::uint8_t> labels = labelsBeside(segment);
        std::vector<std::size_t> own;
        for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
            if (labels[voxel] == segment)
                own.push_back(voxel);
        }
        const std::size_t voxel = own.empty() ? labels.size() / 2 : any(own);
        const auto columns = std::size_t(size.x);
        const auto rows = std::size_t(size.y);
        return {int(voxel % columns), int(voxel / columns % rows), int(voxel / columns / rows)};
    }
    /// Through where its voxels are seen, if it has any.
    SplitByCurve randomCurveSplit(const Document& document)
    {
        using Side = SplitByCurve::Side;
        const DrillStroke stroke = randomDrill();
        SplitByCurve split{.segment = any(document.segments).label, .view = stroke.view};
        split.open = chance(50);
        const double half = stroke.mask.radiusMm + 3.0;
        const glm::dvec2 middle(stroke.samples.front().xMm, stroke.samples.front().yMm);
        split.curveMm = {middle - half, middle + glm::dvec2(half, -half),
            middle + glm::dvec2(-half, half + 1.0)};
        split.side = Side(between(0, 3));
        if (split.side == Side::Inside && chance(50))
            split.depthMm = stroke.depthMm;
        split.hidden = stroke.hidden;
        split.into = {.name = randomName(), .rgb = 0x709080};
        return split;
    }
    MirrorSegment randomMirror(const Document& document)
    {
        MirrorSegment mirror{.segment = any(document.segments).label,
            .sides = MirroredSides(between(0, 2)),
            .keep = chance(50)};
        // At or halfway between voxels, and not where rounding decides.
        if (chance(70))
            mirror.placeLps = document.volumes.front().geometry.toWorld({0.5 * between(8, 30) + 0.1,
                0.5 * between(8, 30) + 0.1, 0.5 * between(8, 30) + 0.1});
        return mirror;
    }
    /// Planes of any direction, and some across the grid's axes, through voxels of a segment. Many
    /// of them hold all that lies between them already.
    FillBetweenSlices randomBetweenPlanes(const Document& document)
    {
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        FillBetweenSlices filling{
            .segment = any(document.segments).label, .planes = std::vector<DrawnPlane>()};
        for (int count = between(2, 5); count > 0; --count) {
            const int right = between(-9, 9);
            const int back = between(-9, 9);
            glm::dvec3 normal(right, back, between(1, 9));
            if (chance(40))
                normal = geometry.direction()[between(0, 2)];
            filling.planes->push_back(
                {geometry.toWorld(glm::dvec3(voxelOf(filling.segment, geometry.size))), normal});
        }
        return filling;
    }
    /// Of a segment that has empty slices between others, along any axis.
    std::optional<FillBetweenSlices> randomBetween(const Document& document)
    {
        if (m_draws.crossing && chance(70))
            return randomBetweenPlanes(document);
        std::vector<FillBetweenSlices> possible;
        for (const Segment& segment : document.segments) {
            const std::vector<std::uint8_t> labels = labelsBeside(segment.label);
            for (const DrawnSlices& drawn : drawnSlices(
                     labels, document.volumes.front().geometry.size, std::uint8_t(segment.label))) {
                if (drawn.emptySlices() > 0 && !segment.locked)
                    possible.push_back({.segment = segment.label, .axis = drawn.axis});
            }
        }
        if (possible.empty())
            return std::nullopt;
        FillBetweenSlices filling = any(possible);
        if (chance(50))
            filling.axis.reset();
        return filling;
    }
    /// From any voxel; of one that a segment has, it may be taken away.
    FloodFill randomFlood(const Document& document)
    {
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        FloodFill flood{.segment = any(document.segments).label};
        const std::vector<std::uint8_t> labels = labelsBeside(flood.segment);
        std::size_t voxel = std::size_t(between(0, int(labels.size()) - 1));
        if (chance(40)) { // the next one of a segment
            const auto next = std::find_if(labels.begin() + std::ptrdiff_t(voxel), labels.end(),
                [](std::uint8_t label) { return label != 0; });
            if (next != labels.end()) {
                voxel = std::size_t(next - labels.begin());
                flood.segment = *next;
                flood.erase = true;
            }
        }
        const auto columns = std::size_t(geometry.size.x);
        const auto rows = std::size_t(geometry.size.y);
        flood.placeLps = geometry.toWorld({double(voxel % columns), double(voxel / columns % rows),
            double(voxel / columns / rows)});
        if (chance(60))
            flood.within = SliceAxis(between(0, 2));
        else if (voxel % 2 == 0)
            flood.normalLps = glm::dvec3(
                double(voxel % 7) - 3.0, double(voxel % 5) - 2.0, 1.0 + double(voxel % 3));
        flood.corners = chance(40);
        if (!flood.erase) {
            flood.tolerance = between(0, 300);
            flood.overwriteUnlocked = chance(40);
        }
        return flood;
    }
    /// Of a segment as it stands, or from a bubble at any voxel.
    EvolveContour randomContour(const Document& document)
    {
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        EvolveContour contour{.segment = any(document.segments).label};
        const double lower = between(-300, 800);
        if (chance(80))
            contour.lower = lower;
        if (chance(80))
            contour.upper = lower + between(0, 600);
        contour.softness = between(0, 100);
        contour.region = between(0, 100);
        contour.smoothness = between(0, 100);
        if (chance(50)) {
            contour.edge = between(1, 100);
            contour.edgeGradient = between(1, 200);
        }
        if (chance(60)) {
            const glm::ivec3 last = geometry.size - 1;
            const glm::dvec3 middle{
                double(between(0, last.x)), double(between(0, last.y)), double(between(0, last.z))};
            const glm::dvec3 spacing = geometry.spacingMm();
            contour.bubbleLps = geometry.toWorld(middle);
            // No distance between two voxels: rounding decides nothing.
            contour.bubbleMm = (between(1, 4) + 0.13) * std::max({spacing.x, spacing.y, spacing.z});
            if (m_session->history().rows().size() % 5 > 2) // of the row's number, as below
                contour.furtherBubblesLps = {geometry.toWorld(glm::dvec3(last) - middle),
                    geometry.toWorld(glm::floor(glm::dvec3(last) / 2.0))};
        }
        contour.generations = between(1, 6);
        contour.overwriteUnlocked = chance(40);
        // Of the row's number, as in randomGrowth().
        if (m_session->history().rows().size() % 3 != 0)
            contour.round = m_session->history().rows().size() % 3 == 1;
        if (m_session->history().rows().size() % 4 == 2) {
            contour.erase = true;
            contour.overwriteUnlocked = false;
        }
        return contour;
    }
    ThresholdSegment randomThreshold(const Document& document)
    {
        ThresholdSegment threshold{.segment = any(document.segments).label};
        threshold.mode = ThresholdSegment::Mode(between(0, 2));
        threshold.onlyVisible = chance(30);
        threshold.overwriteUnlocked = chance(40);
        const double lower = between(-200, 1000);
        threshold.lower = lower;
        // Without a box few values: what takes most of the volume leaves nothing to do.
        if (chance(70)) {
            const VolumeGeometry& geometry = document.volumes.front().geometry;
            const glm::dvec3 from{between(0, 20), between(0, 20), between(0, 20)};
            const glm::dvec3 sides{between(2, 14), between(2, 14), between(2, 14)};
            threshold.box = GrowBox{geometry.toWorld(from), geometry.toWorld(from + sides)};
        } else {
            threshold.upper = lower + between(0, 60);
        }
        return threshold;
    }
    /// Under a curve that drills reach. What lies beside it is most of the volume, so it is only
    /// erased, and of some values.
    SegmentScissors randomSnip(const Document& document)
    {
        const DrillStroke stroke = randomDrill();
        const double half = stroke.mask.radiusMm;
        const glm::dvec2 middle(stroke.samples.front().xMm, stroke.samples.front().yMm);
        SegmentScissors scissors{.segment = any(document.segments).label,
            .view = stroke.view,
            .polygonMm = {middle - half, middle + glm::dvec2(half, -half),
                middle + glm::dvec2(-half, half), middle + half + 1.0}};
        scissors.hidden = stroke.hidden;
        scissors.erase = chance(50);
        scissors.outside = scissors.erase && chance(30);
        if (!scissors.outside && chance(60))
            scissors.depthMm = stroke.depthMm;
        scissors.overwriteUnlocked = !scissors.erase && chance(40);
        if (scissors.outside || chance(30))
            scissors.lower = between(-200, 300);
        std::vector<int> others;
        for (const Segment& other : document.segments) {
            const bool isBeside = other.label != scissors.segment
                && other.plane == document.segment(scissors.segment)->plane;
            if (scissors.erase && isBeside && !other.locked && chance(30))
                others.push_back(other.label);
        }
        std::sort(others.begin(), others.end());
        if (!others.empty())
            scissors.others = others;
        return scissors;
    }
    ReshapeSegment randomReshape(const Document& document)
    {
        const glm::dvec3 spacing = document.volumes.front().geometry.spacingMm();
        // No distance between two voxels: rounding decides nothing.
        ReshapeSegment reshape{.segment = any(document.segments).label,
            .operation = ShapeOperation(between(0, 7)),
            .mm = (between(1, 3) + 0.13) * std::max({spacing.x, spacing.y, spacing.z})};
        if (reshape.operation == ShapeOperation::Hollow && chance(60))
            reshape.shell = ShellPlace(between(0, 2));
        if (reshape.operation <= ShapeOperation::Shrink && chance(30)) {
            reshape.sides.leftMm = 0.0;
            reshape.sides.superiorMm = 1.5 * reshape.mm;
        }
        // Beside others of its plane that may be changed.
        std::vector<int> others;
        for (const Segment& each : document.segments) {
            if (!each.locked && each.label != reshape.segment
                && each.plane == document.segment(reshape.segment)->plane)
                others.push_back(each.label);
        }
        if (reshape.operation == ShapeOperation::Gaussian && !others.empty() && chance(50)) {
            // Of the row's number, as in randomGrowth(): with those of other planes.
            if (m_session->history().rows().size() % 2 == 1) {
                for (const Segment& each : document.segments) {
                    if (!each.locked && each.plane != document.segment(reshape.segment)->plane)
                        others.push_back(each.label);
                }
            }
            std::sort(others.begin(), others.end());
            reshape.with = others;
        }
        return reshape;
    }
    PaintStroke randomPaint(int segment)
    {
        PaintStroke stroke{.segment = segment, .path = randomPath()};
        stroke.erase = chance(30);
        stroke.seeds = chance(50);
        stroke.overwriteUnlocked = chance(40);
        if (chance(30))
            stroke.lower = between(-200, 300);
        // Of the row's number, as in randomGrowth().
        if (m_session->history().rows().size() % 4 == 1)
            stroke.edgeTolerance = 120.0;
        if (stroke.edgeTolerance && stroke.path.pressures)
            stroke.toleranceByPressure = m_session->history().rows().size() % 8 == 1;
        const bool isPlainDisc =
            stroke.path.shape == BrushPath::Shape::Disc && !stroke.edgeTolerance;
        if (isPlainDisc && m_session->history().rows().size() % 2 == 0)
            stroke.tool = PaintStroke::Tool::Nudge;
        return stroke;
    }
    BrushStroke randomBrush()
    {
        BrushStroke stroke{.layer = any(m_session->document().layers).id, .path = randomPath()};
        stroke.restore = chance(40);
        return stroke;
    }
    Edit randomOutlined()
    {
        const DrillStroke stroke = randomDrill();
        const double half = stroke.mask.radiusMm;
        const glm::dvec2 middle(stroke.samples.front().xMm, stroke.samples.front().yMm);
        const std::vector<glm::dvec2> outline{middle - half, middle + glm::dvec2(half, -half),
            middle + glm::dvec2(-half, half), middle + half + 1.0};
        if (chance(60))
            return PeelCut{.layer = stroke.layer,
                .view = stroke.view,
                .polygonMm = outline,
                .depthMm = std::min(stroke.depthMm, 40.0),
                .surfaceThreshold = stroke.surfaceThreshold,
                .throughGaps = stroke.throughGaps,
                .restore = stroke.restore,
                .hidden = stroke.hidden};
        ScissorsCut cut{.layer = stroke.layer, .view = stroke.view, .polygonMm = outline};
        cut.surfaceThreshold = stroke.surfaceThreshold;
        cut.restore = stroke.restore;
        cut.firstLayerOnly = !cut.restore && chance(50);
        if (chance(50))
            cut.depthMm = stroke.depthMm;
        return cut;
    }
    ReviseStroke randomRevision(const std::vector<RowId>& rows)
    {
        ReviseStroke revise{.row = any(rows)};
        if (chance(60))
            revise.radiusMm = between(10, 70) / 10.0;
        if (chance(40))
            revise.depthMm = between(10, 90) / 10.0;
        if (chance(20))
            revise.layer = any(m_session->document().layers).id;
        if (chance(20))
            revise.throughGaps = chance(50);
        if (chance(15))
            revise.softnessMm = between(0, 30) / 10.0;
        revise.removed = chance(25);
        return revise;
    }
    Edit randomRevert(const std::vector<RowId>& rows)
    {
        // Late rows are the ones that are free more often than not.
        RevertRows revert;
        const int count = std::min(int(rows.size()), between(1, 2));
        for (int i = 0; i < count; ++i)
            revert.rows.push_back(
                rows[rows.size() - 1 - std::size_t(between(0, std::min(5, int(rows.size()) - 1)))]);
        std::sort(revert.rows.begin(), revert.rows.end());
        revert.rows.erase(std::unique(revert.rows.begin(), revert.rows.end()), revert.rows.end());
        return revert;
    }

    void takeRows()
    {
        const std::vector<HistoryRow>& rows = m_session->history().rows();
        for (; m_known < rows.size(); ++m_known)
            m_truth.add(rows[m_known]);
    }

    EditEngine& m_engine;
    RandomDraws m_draws;
    std::mt19937 m_random;
    QTemporaryDir m_folder;
    HistoryTruth m_truth;
    std::size_t m_known = 0; ///< rows
    std::vector<glm::dvec3> m_sketched; ///< places of seeds, done or undone
    RandomHistory m_result;
    std::function<void(bool)> m_acting;
    bool m_isLost = false;
    std::unique_ptr<EditSession> m_session;
};

} // namespace

RandomHistory runRandomHistory(EditEngine& engine, int commands, std::uint32_t seed,
    const std::function<void(bool)>& acting, const RandomDraws& draws)
{
    return HastyUser(engine, seed, draws).run(commands, acting);
}

} // namespace test
