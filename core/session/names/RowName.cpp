// SPDX-License-Identifier: Apache-2.0
#include "core/session/names/RowName.h"

#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/session/names/ChangeName.h"
#include "core/session/names/ChunkName.h"
#include "core/session/names/SurfaceName.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <map>

namespace core {

using namespace rowWords;

namespace {

/// "'Brain' ", "2 segments ", or nothing if only seeds became members.
QString whatGrew(const ChangeFacts& facts, const Document& document)
{
    std::bitset<256> grew;
    for (const LabelFlow& flow : facts.flows) {
        if (flow.gained > 0)
            grew.set(flow.label);
    }
    if (grew.none())
        return {};
    if (grew.count() > 1)
        return counted(std::int64_t(grew.count()), "segment") + QLatin1Char(' ');
    int label = 1;
    while (!grew.test(std::size_t(label)))
        ++label;
    return QStringLiteral("'%1' ").arg(segmentName(label, document));
}

template <class Stroke> double deepestMm(const Stroke& stroke)
{
    double pressure = 0.0;
    for (const PenSample& sample : stroke.samples)
        pressure = std::max(pressure, sample.pressure);
    return stroke.depthMm * std::pow(pressure, stroke.pressureExponent);
}

/// "Drill 6.2 mm, 214 bricks"; @param verbs carving and restoring
template <class Stroke>
QString pressedName(
    const Stroke& stroke, const std::array<const char*, 2>& verbs, const EditStatistics& statistics)
{
    const QString depth = QString::number(deepestMm(stroke), 'f', 1);
    return QLatin1String(verbs[stroke.restore ? 1 : 0])
        + (stroke.mode == DrillMode::Rate ? QStringLiteral("%1 mm/s, ") : QStringLiteral("%1 mm, "))
              .arg(depth)
        + counted(statistics.bricks, "brick");
}

/// "Peel 4.0 mm, 214 bricks".
QString peelName(const PeelCut& peel, const EditStatistics& statistics)
{
    return (peel.restore ? QStringLiteral("Restore peel ") : QStringLiteral("Peel "))
        + QStringLiteral("%1 mm, ").arg(QString::number(peel.depthMm, 'f', 1))
        + counted(statistics.bricks, "brick");
}

/// "Carve scissors 12.0 mm deep, 214 bricks".
QString scissorsName(const ScissorsCut& cut, const EditStatistics& statistics)
{
    QString name =
        cut.restore ? QStringLiteral("Restore scissors") : QStringLiteral("Carve scissors");
    if (cut.depthMm)
        name += QStringLiteral(" %1 mm deep").arg(QString::number(*cut.depthMm, 'f', 1));
    if (cut.firstLayerOnly)
        name += QStringLiteral(" through the first layer");
    return name + QStringLiteral(", ") + counted(statistics.bricks, "brick");
}

QString removeName(const RemoveSegment& edit, const EditStatistics& statistics,
    const ChangeFacts& facts, const Document& document)
{
    const std::int64_t seeds = facts.seedWordsChanged;
    QString lost = QStringLiteral("empty");
    if (statistics.voxelsChanged > 0)
        lost = QStringLiteral("−") + counted(statistics.voxelsChanged, "voxel");
    else if (seeds > 0)
        lost = QStringLiteral("−") + counted(seeds, "seed voxel");
    return QStringLiteral("Delete segment %1, %2")
        .arg(quoted(segmentName(edit.segment, document)), lost);
}

QString seedName(const SeedStroke& stroke, const ChangeFacts& facts, const Document& document,
    const std::optional<SketchedSeeds>& sketched)
{
    const QString segment = segmentName(stroke.segment, document);
    if (stroke.takenLps && stroke.pointsLps.size() == stroke.takenLps->size())
        return QStringLiteral("Move %1 of '%2'")
                   .arg(counted(std::int64_t(stroke.pointsLps.size()), "seed"), segment)
            + (sketched && !whyNotTaken(*sketched, document).isEmpty()
                    ? QStringLiteral(", ") + sketchedText(*sketched, document)
                    : QString());
    const QString voxels = counted(facts.seedWordsChanged, "voxel");
    if (stroke.pointsLps.empty())
        return QStringLiteral("Take seeds of '%1' away, %2").arg(segment, voxels);
    return QStringLiteral("Seed stroke for '%1', %2")
        .arg(segment, sketched ? sketchedText(*sketched, document) : voxels);
}

QString paintName(const PaintStroke& stroke, const EditStatistics& statistics,
    const ChangeFacts& facts, const Document& document)
{
    // What only makes seeds of painted voxels, or takes seeds away, changes no label.
    const std::int64_t voxels = statistics.voxelsChanged;
    const QString count =
        voxels > 0 ? counted(voxels, "voxel") : counted(facts.seedWordsChanged, "seed voxel");
    return QStringLiteral("%1 %2 %3, %4%5")
        .arg(stroke.erase ? QStringLiteral("Erase") : QStringLiteral("Paint"),
            quoted(segmentName(stroke.segment, document)), millimetres(stroke.path.radiusMm),
            stroke.erase ? QStringLiteral("−") : QStringLiteral("+"), count);
}

/// "120 … 300 HU"
QString intervalText(const GrowCriteria& criteria, const Document& document)
{
    const QString unit = document.volumes.front().unit;
    return QStringLiteral("%1 … %2%3")
        .arg(QString::number(criteria.lower, 'g', 6), QString::number(criteria.upper, 'g', 6),
            unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
}

QString growName(const GrowSteps& grow, const EditStatistics& statistics, const ChangeFacts& facts,
    const Document& document)
{
    if (facts.empty())
        return QStringLiteral("Grow %1, no voxel").arg(intervalText(grow.criteria, document));
    const Growth* before = document.growth(0);
    const int steps = grownSteps(before ? before->generation : 0, statistics, facts);
    return QStringLiteral("Grow %1%2, +%3")
        .arg(whatGrew(facts, document), counted(steps, "step"),
            counted(statistics.voxelsChanged, "voxel"));
}

/// "Recover 120 … 300 HU, +2 104 voxels"; the name says what was done.
QString intervalName(
    const ChangeInterval& change, const ChangeFacts& facts, const Document& document)
{
    const std::int64_t gained = facts.labelsGrown;
    const std::int64_t lost = facts.labelsLost;
    const QString what = change.fromSeeds.value_or(false) ? QStringLiteral("Grow anew from seeds")
        : gained > 0 && lost > 0                          ? QStringLiteral("Recover and withdraw")
        : lost > 0                                        ? QStringLiteral("Withdraw to")
                                                          : QStringLiteral("Recover");
    QStringList figures;
    if (gained > 0)
        figures += QLatin1Char('+') + grouped(gained);
    if (lost > 0)
        figures += QStringLiteral("−") + grouped(lost);
    if (facts.empty())
        return QStringLiteral("Interval %1, no voxel").arg(intervalText(change.criteria, document));
    return QStringLiteral("%1 %2, %3")
        .arg(what, intervalText(change.criteria, document),
            figures.isEmpty() ? counted(facts.seedWordsChanged, "seed voxel")
                              : figures.join(QLatin1Char(' ')) + QStringLiteral(" voxels"));
}

/// "Import 7 segments of liver.dcm, 12.3 mL"
QString importName(
    const ImportMask& mask, const EditStatistics& statistics, const Document& document)
{
    const qsizetype slash = mask.file.lastIndexOf(QLatin1Char('/'));
    const auto count = std::int64_t(mask.segments ? mask.segments->size() : 0);
    const double ml = double(statistics.voxelsChanged)
        * document.volumes.front().geometry.voxelVolumeMm3() / 1000.0;
    QString what =
        QStringLiteral("Import %1 of %2").arg(counted(count, "segment"), mask.file.mid(slash + 1));
    if (mask.as)
        what += QStringLiteral(" as ")
            + quoted(mask.as->number ? segmentName(*mask.as->number, document) : mask.as->name);
    return what + QStringLiteral(", %1 mL").arg(ml, 0, 'f', ml < 1.0 ? 3 : 1);
}

/// A row without the figures at its end: "Drill 6.2 mm, 214 bricks" → "Drill 6.2 mm".
QString titleOf(const HistoryRow& row)
{
    const qsizetype figures = row.name.lastIndexOf(QLatin1String(", "));
    return figures < 0 ? row.name : row.name.left(figures);
}

QString revertName(const RevertRows& edit, const EditStatistics& statistics,
    const ChangeFacts& facts, const History& history)
{
    const QString what = edit.rows.size() == 1
        ? QLatin1Char('\'') + titleOf(history.row(edit.rows.front())) + QLatin1Char('\'')
        : counted(std::int64_t(edit.rows.size()), "step");
    const std::int64_t voxels = statistics.voxelsChanged;
    return QStringLiteral("Undo only ") + what + QStringLiteral(", ")
        + (voxels > 0 ? counted(voxels, "voxel") : counted(facts.seedWordsChanged, "seed voxel"));
}

QString revisionName(
    const ReviseStroke& edit, const EditStatistics& statistics, const History& history)
{
    const HistoryRow& row = history.row(edit.row);
    const StrokeParameters drawn = parametersOf(*sculptEdit(row.edit));
    const QString title = QLatin1Char('\'') + titleOf(row) + QLatin1Char('\'');
    QString what;
    if (edit.removed) {
        what = QStringLiteral("Remove ") + title;
    } else {
        const auto mm = [](double value) { return QString::number(value, 'f', 1); };
        QStringList changes;
        if (edit.radiusMm)
            changes +=
                QStringLiteral("radius %1 → %2 mm").arg(mm(*drawn.radiusMm), mm(*edit.radiusMm));
        if (edit.sideMm)
            changes += QStringLiteral("side %1 → %2 mm").arg(mm(*drawn.sideMm), mm(*edit.sideMm));
        if (edit.widthMm)
            changes +=
                QStringLiteral("width %1 → %2 mm").arg(mm(*drawn.widthMm), mm(*edit.widthMm));
        if (edit.heightMm)
            changes +=
                QStringLiteral("height %1 → %2 mm").arg(mm(*drawn.heightMm), mm(*edit.heightMm));
        if (edit.factor)
            changes += QStringLiteral("outline × %1").arg(QString::number(*edit.factor, 'g', 4));
        if (edit.depthMm)
            changes +=
                QStringLiteral("depth %1 → %2 mm").arg(mm(*drawn.depthMm), mm(*edit.depthMm));
        if (edit.softnessMm)
            changes += QStringLiteral("soft edge %1 → %2 mm")
                           .arg(mm(*drawn.softnessMm), mm(*edit.softnessMm));
        if (edit.layer)
            changes += QStringLiteral("layer %1 → %2").arg(drawn.layer).arg(*edit.layer);
        if (edit.throughGaps)
            changes += *edit.throughGaps ? QStringLiteral("through gaps")
                                         : QStringLiteral("stopping at gaps");
        what = QStringLiteral("Revise ") + title + QStringLiteral(": ")
            + (changes.isEmpty() ? QStringLiteral("as it was drawn")
                                 : changes.join(QStringLiteral(" and ")));
    }
    return what + QStringLiteral(", ") + counted(statistics.voxelsChanged, "voxel");
}

/// The name of each kind of edit: one that has none does not compile.
class RowNames {
public:
    const EditStatistics& statistics;
    const ChangeFacts& facts;
    const Document& document;
    const History& history;
    const std::optional<SketchedSeeds>& sketched;

    QString operator()(const AddSegment& add) const
    {
        return QStringLiteral("Add segment '%1'").arg(add.name);
    }
    QString operator()(const ChangeSegment& change) const { return changeName(change, document); }
    QString operator()(const MoveSegment& move) const
    {
        return QStringLiteral("Move segment '%1' to place %2")
            .arg(segmentName(move.segment, document))
            .arg(move.place);
    }
    QString operator()(const RemoveSegment& remove) const
    {
        return removeName(remove, statistics, facts, document);
    }
    QString operator()(const AddLayer& add) const
    {
        return QStringLiteral("Add layer ") + quoted(add.name);
    }
    QString operator()(const ChangeLayer& change) const { return changeName(change, document); }
    QString operator()(const MoveLayer& move) const
    {
        return QStringLiteral("Move layer %1 to place %2")
            .arg(layerName(move.layer, document))
            .arg(move.place);
    }
    QString operator()(const RemoveLayer& remove) const
    {
        return QStringLiteral("Delete layer ") + layerName(remove.layer, document);
    }
    QString operator()(const MergeLayers& merge) const
    {
        return QStringLiteral("Merge layer %1 into %2")
            .arg(layerName(merge.from, document), layerName(merge.into, document));
    }
    QString operator()(const AddMeasurement& add) const
    {
        return QStringLiteral("Measure ") + millimetres(glm::distance(add.fromLps, add.toLps));
    }
    QString operator()(const RemoveMeasurement& remove) const
    {
        const Measurement* measurement = document.measurement(remove.measurement);
        return QStringLiteral("Remove measurement ")
            + (measurement ? millimetres(measurement->lengthMm())
                           : QString::number(remove.measurement));
    }
    QString operator()(const AddBookmark& add) const
    {
        return QStringLiteral("Bookmark ") + quoted(add.name);
    }
    QString operator()(const RemoveBookmark& remove) const
    {
        const CameraBookmark* bookmark = document.bookmark(remove.bookmark);
        return QStringLiteral("Remove bookmark ")
            + quoted(bookmark ? bookmark->name : QString::number(remove.bookmark));
    }

    QString operator()(const CutPiece& cut) const
    {
        return QStringLiteral("Lift %1 off layer %2")
            .arg(quoted(cut.name), layerName(cut.layer, document));
    }
    QString operator()(const PastePiece& paste) const
    {
        return QStringLiteral("Paste segment %1 as piece %2")
            .arg(quoted(segmentName(paste.segment, document)), quoted(paste.name));
    }
    QString operator()(const ChangePiece& change) const { return changeName(change, document); }
    QString operator()(const SendPiecesHome&) const
    {
        return QStringLiteral("Send all pieces home");
    }
    QString operator()(const RemovePiece& remove) const
    {
        return QStringLiteral("Remove piece ") + pieceName(remove.piece, document);
    }

    QString operator()(const SeedStroke& seed) const
    {
        return seedName(seed, facts, document, sketched);
    }
    QString operator()(const GrowSteps& grow) const
    {
        return growName(grow, statistics, facts, document);
    }
    /// It is kept as the growth that it was.
    QString operator()(const ResumeGrowth& resume) const
    {
        return growName({.steps = resume.steps}, statistics, facts, document);
    }
    QString operator()(const ChangeInterval& change) const
    {
        return intervalName(change, facts, document);
    }
    QString operator()(const GrowFromSeeds&) const
    {
        return QStringLiteral("Grow %1from seeds, +%2")
            .arg(whatGrew(facts, document), counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const ShrinkSteps& shrink) const
    {
        return QStringLiteral("Shrink %1, −%2")
            .arg(shrink.steps ? counted(statistics.generations, "step")
                              : QStringLiteral("to the seeds"),
                counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const ShrinkAt& shrink) const
    {
        return QStringLiteral("Shrink %1, −%2")
            .arg(shrink.onlyHere ? QStringLiteral("only here") : QStringLiteral("here"),
                counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const PlugLeak&) const
    {
        return QStringLiteral("Plug leak, −%1").arg(counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const BarrierStroke& barrier) const
    {
        return QStringLiteral("%1 %2, %3")
            .arg(barrier.erase ? QStringLiteral("Open barrier") : QStringLiteral("Barrier"),
                millimetres(barrier.path.radiusMm), counted(facts.seedWordsChanged, "voxel"));
    }
    QString operator()(const SurfaceBarrier& barrier) const
    {
        return QStringLiteral("%1, %2").arg(barrier.erase
                ? QStringLiteral("Open barrier around surface")
                : QStringLiteral("Barrier around surface"),
            counted(facts.seedWordsChanged, "voxel"));
    }

    QString operator()(const RevertRows& revert) const
    {
        return revertName(revert, statistics, facts, history);
    }
    QString operator()(const ReviseStroke& revise) const
    {
        return revisionName(revise, statistics, history);
    }

    QString operator()(const PaintStroke& paint) const
    {
        return paintName(paint, statistics, facts, document);
    }
    QString operator()(const BrushStroke& brush) const
    {
        return QStringLiteral("%1 %2, %3")
            .arg(brush.restore ? QStringLiteral("Restore brush") : QStringLiteral("Carve brush"),
                millimetres(brush.path.radiusMm), counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const DrillStroke& drill) const
    {
        return pressedName(drill, {"Drill ", "Restore "}, statistics);
    }
    QString operator()(const LaserStroke& laser) const
    {
        return pressedName(laser, {"Laser ", "Restore laser "}, statistics);
    }
    QString operator()(const PeelCut& peel) const { return peelName(peel, statistics); }
    QString operator()(const ScissorsCut& cut) const { return scissorsName(cut, statistics); }

    QString operator()(const ImportMask& mask) const
    {
        return importName(mask, statistics, document);
    }
    QString operator()(const LayerToSegment& carved) const
    {
        return QStringLiteral("Layer %1 to segment %2, +%3")
            .arg(layerName(carved.layer, document), targetName(carved.target, document),
                counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const SegmentSeen& seen) const
    {
        return QStringLiteral("Segment what is seen as %1, +%2")
            .arg(targetName(seen.target, document), counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const SegmentToLayer& segment) const
    {
        return QStringLiteral("Segment %1 to layer %2, %3")
            .arg(quoted(segmentName(segment.segment, document)), layerName(segment.layer, document),
                counted(statistics.voxelsChanged, "voxel"));
    }
    QString operator()(const Chunks& chunks) const { return chunksName(chunks, document); }
    QString operator()(const ChunkToggle& toggle) const
    {
        return chunksName(toggle, facts, document);
    }
    template <class E>
    requires isSurfaceEdit<E> QString operator()(const E& edit) const
    {
        return surfaceName(edit, statistics, document);
    }
};

} // namespace

QString rowName(const Edit& edit, const EditStatistics& statistics, const ChangeFacts& facts,
    const Document& document, const History& history, const std::optional<SketchedSeeds>& sketched)
{
    return visitEdit(RowNames{.statistics = statistics,
                         .facts = facts,
                         .document = document,
                         .history = history,
                         .sketched = sketched},
        edit);
}

} // namespace core
