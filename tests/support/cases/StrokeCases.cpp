// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/StrokeCases.h"

#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/SurfaceEdit.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/Chunks.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowBox.h"
#include "core/edits/kinds/growth/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/HiddenSides.h"
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
#include "core/edits/kinds/sculpt/PenSample.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ImportMask.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/surface/SurfacePath.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/session/EditSession.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace test {

namespace {

using core::EditSession;

struct Failure {
    QString text;
};

void require(const core::Result<void>& result, const char* what)
{
    if (!result)
        throw Failure{QLatin1String(what) + QStringLiteral(": ")
            + result.error().arguments.join(QStringLiteral(": "))};
}

std::unique_ptr<EditSession> begun(
    core::EditEngine& engine, const StrokeCase& strokeCase, const QString& file)
{
    auto session = EditSession::create(engine, strokeCase.volume, {.file = file});
    if (!session)
        throw Failure{
            QStringLiteral("create: ") + session.error().arguments.join(QStringLiteral(": "))};
    for (const core::Edit& edit : strokeCase.before)
        require((*session)->apply(edit), "an edit before");
    require((*session)->settle(), "settle");
    return std::move(*session);
}

QByteArray settledHash(EditSession& session)
{
    require(session.settle(), "settle");
    return session.stateHash();
}

/// As the pen tells a stroke and the panel a growth; nothing for edits that are made at once.
bool tellInPieces(EditSession& session, const core::Edit& edit, core::Ending ending)
{
    const auto* drill = edit.as<core::DrillStroke>();
    const auto* laser = edit.as<core::LaserStroke>();
    if (drill || laser) {
        core::Edit stroke = edit;
        std::vector<core::PenSample>& told = drill ? stroke.get<core::DrillStroke>().samples
                                                   : stroke.get<core::LaserStroke>().samples;
        const std::vector<core::PenSample> samples = std::exchange(told, {});
        require(session.begin(stroke), "begin");
        for (std::size_t first = 0; first < samples.size(); first += 2) {
            const std::size_t last = std::min(first + 2, samples.size());
            session.extendDrill(
                {samples.begin() + std::ptrdiff_t(first), samples.begin() + std::ptrdiff_t(last)});
            session.poll();
        }
    } else if (edit.is<core::PaintStroke>() || edit.is<core::BarrierStroke>()
        || edit.is<core::BrushStroke>()) {
        core::Edit first = edit;
        auto* paint = first.as<core::PaintStroke>();
        auto* barrier = first.as<core::BarrierStroke>();
        core::BrushPath& path = paint ? paint->path
            : barrier                 ? barrier->path
                                      : first.get<core::BrushStroke>().path;
        const core::BrushPath whole = path;
        const std::vector<glm::dvec3>& points = whole.pointsLps;
        path.pointsLps.resize(1);
        path.lifts.clear();
        require(session.begin(first), "begin");
        for (std::size_t next = 1; next < points.size(); ++next) {
            session.extendPath({points[next]},
                std::find(whole.lifts.begin(), whole.lifts.end(), std::int64_t(next))
                    != whole.lifts.end());
            session.poll();
        }
    } else if (const core::SurfacePath* surface = core::surfacePathOf(edit)) {
        core::Edit first = edit;
        core::surfacePathOf(first)->pointsLps.resize(1);
        require(session.begin(first), "begin");
        for (std::size_t next = 1; next < surface->pointsLps.size(); ++next) {
            session.extendPath({surface->pointsLps[next]});
            session.poll();
        }
    } else if (const auto* peel = edit.as<core::PeelCut>()) {
        core::PeelCut first = *peel;
        first.depthMm = std::min(2.0 * peel->depthMm + 1.0, 60.0);
        require(session.begin(first), "begin");
        for (const double depthMm : {1.0, 0.0, 0.5 * peel->depthMm, peel->depthMm}) {
            session.setPeelDepth(depthMm);
            session.poll();
        }
    } else if (const auto* change = edit.as<core::ChangeInterval>()) {
        // As a slider is dragged.
        core::ChangeInterval first = *change;
        first.criteria.upper += 200.0;
        require(session.begin(first), "begin");
        session.extendGrowth({});
        session.poll();
        session.setInterval(change->criteria.lower - 100.0, change->criteria.upper);
        session.extendGrowth({});
        session.poll();
        session.setInterval(change->criteria.lower, change->criteria.upper);
        session.extendGrowth({.steps = change->steps.value_or(core::GrowAdvance::toClosure)});
    } else if (const auto* resume = edit.as<core::ResumeGrowth>()) {
        require(session.begin(*resume), "begin");
        session.extendGrowth({.steps = resume->steps.value_or(core::GrowAdvance::toClosure)});
    } else if (edit.is<core::GrowFromSeeds>()) {
        require(session.begin(edit), "begin");
        // Whatever else is done takes a preview back, and the next goes on from what it found.
        session.closeGrowth();
        session.poll();
        require(session.begin(edit), "begin again");
        session.poll();
    } else if (const auto* grow = edit.as<core::GrowSteps>()) {
        require(session.begin(*grow), "begin");
        const int steps = grow->steps.value_or(core::GrowAdvance::toClosure);
        if (steps > 1) {
            session.extendGrowth({.steps = 1});
            session.poll();
            session.extendGrowth({.steps = steps - 1});
        } else {
            session.extendGrowth({.steps = steps});
        }
    } else {
        return false;
    }
    session.end(ending);
    session.poll();
    return true;
}

StrokeHashes run(core::EditEngine& engine, const StrokeCase& strokeCase)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("stroke.burin"));
    StrokeHashes hashes;
    std::vector<core::Edit> recorded;
    {
        const auto session = begun(engine, strokeCase, file);
        hashes.before = settledHash(*session);
        const std::size_t rows = session->history().rows().size();
        tellInPieces(*session, strokeCase.edit, core::Ending::Rollback);
        hashes.cancelled = settledHash(*session);
        if (session->history().rows().size() != rows)
            throw Failure{QStringLiteral("a cancelled edit left a row")};

        require(session->apply(strokeCase.edit), "apply");
        hashes.finished = settledHash(*session);
        // An edit that changed nothing leaves no row, and undo must not take back another.
        if (session->history().rows().size() == rows) {
            hashes.undone = hashes.before;
            hashes.redone = hashes.again = hashes.finished;
        } else {
            require(session->undo(), "undo");
            hashes.undone = settledHash(*session);
            require(session->redo(), "redo");
            hashes.redone = settledHash(*session);
            require(session->undo(), "undo");
            require(session->apply(strokeCase.edit), "apply again");
            hashes.again = settledHash(*session);
        }
        const core::History& history = session->history();
        for (const core::RowId row : history.pathTo(history.position()))
            recorded.push_back(history.row(row).edit);
    }
    {
        auto session = EditSession::open(engine, strokeCase.volume, file);
        if (!session)
            throw Failure{
                QStringLiteral("open: ") + session.error().arguments.join(QStringLiteral(": "))};
        hashes.reopened = settledHash(**session);
    }
    {
        const auto session = begun(engine, strokeCase, {});
        if (tellInPieces(*session, strokeCase.edit, core::Ending::Commit))
            hashes.inPieces = settledHash(*session);
        else
            hashes.inPieces = hashes.finished;
    }
    StrokeCase bare = strokeCase;
    bare.before.clear();
    const auto session = begun(engine, bare, {});
    for (const core::Edit& edit : recorded)
        require(session->apply(edit), "replay");
    hashes.replayed = settledHash(*session);
    return hashes;
}

core::LoadedVolume loaded(const core::Document& document, const Codes& codes)
{
    core::LoadedVolume made{document.volumes.front(), codes.values};
    made.volume.minimum = 0.0;
    made.volume.maximum = 65535.0;
    made.volume.voxelsSha256 = "not looked at here";
    return made;
}

core::SeedStroke randomSeeds(const core::Document& document, int segment, Random& random)
{
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    core::SeedStroke seeds{segment, {}};
    for (int i = randomInt(random, 1, 6); i > 0; --i) {
        const glm::dvec3 jitter(0.4 * randomUnit(random));
        seeds.pointsLps.push_back(
            geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size)) + jitter));
    }
    return seeds;
}

/// Limits beside the interval, any of them or none.
void addRandomLimits(
    core::GrowCriteria& criteria, const core::VolumeGeometry& geometry, Random& random)
{
    const auto maybe = [&random](double greatest) {
        return random() % 4 ? std::nullopt : std::optional(greatest * randomUnit(random));
    };
    if (random() % 4 == 0)
        criteria.sigmas = randomInt(random, 1, 1500) / 256.0;
    if (criteria.sigmas && int(*criteria.sigmas * 256.0) % 2 == 0)
        criteria.perStroke = true;
    criteria.difference = maybe(tissueCode);
    criteria.gradient = maybe(tissueCode);
    criteria.gradientDifference = maybe(tissueCode);
    if (random() % 4 == 0)
        criteria.majority = randomInt(random, 1, 20);
    criteria.onlyVisible = random() % 3 == 0;
    if (random() % 4 == 0)
        criteria.box =
            core::GrowBox{geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size))),
                geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size)))};
    if (random() % 4 == 0)
        criteria.passage = 6.0 * randomUnit(random) * geometry.spacingMm()[int(random() % 3)];
}

core::GrowSteps randomGrowth(const core::Document& document, Random& random)
{
    core::GrowSteps grow;
    grow.criteria.lower = randomInt(random, 0, tissueCode / 2);
    grow.criteria.upper = randomInt(random, tissueCode / 2, tissueCode);
    grow.criteria.overwriteUnlocked = random() % 2;
    if (random() % 2)
        grow.steps = randomInt(random, 1, 12);
    grow.criteria.connectivity =
        std::array<int, 3>{6, 18, 26}[std::size_t(grow.criteria.upper) % 3];
    // Of a generator of their own: older cases stay as they are.
    Random limits(std::uint32_t(grow.criteria.lower * 1009.0 + grow.criteria.upper));
    if (limits() % 2)
        addRandomLimits(grow.criteria, document.volumes.front().geometry, limits);
    return grow;
}

core::AddSegment segmentNamed(const char* name)
{
    core::AddSegment segment;
    segment.name = QLatin1String(name);
    segment.rgb = 0x40C080;
    return segment;
}

core::AddBookmark bookmarkOf(const core::DrillStroke& stroke)
{
    core::AddBookmark bookmark;
    bookmark.name = QStringLiteral("From there");
    bookmark.view = stroke.view;
    bookmark.crosshairLps = stroke.view.targetLps;
    return bookmark;
}

/// A session that adds, mutes and deletes between its strokes; the last edit is the one in hand.
StrokeCase randomLists(int number)
{
    Random random(std::uint32_t(3700 + number));
    const glm::ivec3 extent{
        randomInt(random, 3, 40), randomInt(random, 3, 40), randomInt(random, 3, 30)};
    const core::Document scene = randomDocument(extent, random, number % 2);
    StrokeCase made{"random lists " + QByteArray::number(number),
        loaded(scene, number % 3 ? balls(extent, 5, random) : shells(extent)),
        {segmentNamed("First"), segmentNamed("Second"), segmentNamed("Third"),
            core::AddLayer{.name = QStringLiteral("Other")}},
        {}};
    std::vector<int> segments{1, 2, 3};
    int bookmarks = 0;
    int removed = 0; // of the bookmarks, the first so many
    std::array<bool, 3> muted{};
    for (int i = randomInt(random, 6, 14); i > 0; --i) {
        const int layer = randomInt(random, 1, 2);
        switch (random() % 9) {
        case 0:
        case 1:
            if (!segments.empty())
                made.before.push_back(
                    randomSeeds(scene, segments[random() % segments.size()], random));
            break;
        case 2:
            made.before.push_back(randomGrowth(scene, random));
            break;
        case 3:
            muted[std::size_t(layer)] = !muted[std::size_t(layer)];
            made.before.push_back(
                core::ChangeLayer{.layer = layer, .muted = muted[std::size_t(layer)]});
            break;
        case 4:
            if (!segments.empty()) {
                const auto which = segments.begin() + std::ptrdiff_t(random() % segments.size());
                made.before.push_back(core::RemoveSegment{.segment = *which});
                segments.erase(which);
            }
            break;
        case 5:
            made.before.push_back(bookmarkOf(randomDrill(scene, random)));
            ++bookmarks;
            break;
        case 6:
            if (bookmarks > removed)
                made.before.push_back(core::RemoveBookmark{.bookmark = ++removed});
            break;
        default: {
            core::DrillStroke stroke = randomDrill(scene, random);
            stroke.layer = layer;
            if (!muted[std::size_t(layer)])
                made.before.push_back(stroke);
            break;
        }
        }
    }
    made.edit = made.before.back();
    made.before.pop_back();
    return made;
}

core::Edit randomEdit(const core::Document& document, Random& random)
{
    switch (random() % 10) {
    case 9: {
        core::LaserStroke stroke = randomLaser(document, random);
        stroke.layer = 1;
        return stroke;
    }
    case 0:
        return randomSeeds(document, randomInt(random, 1, 2), random);
    case 5: {
        core::PeelCut peel = randomPeel(document, random);
        peel.layer = 1;
        return peel;
    }
    case 6: {
        core::ScissorsCut cut = randomScissors(document, random);
        cut.layer = 1;
        return cut;
    }
    case 1:
    case 2:
        return randomGrowth(document, random);
    case 3: {
        core::Document segmented = document;
        segmented.segments = {{.label = 1}, {.label = 2}};
        return randomPaint(segmented, random);
    }
    case 4: {
        core::BrushStroke stroke = randomBrush(document, random);
        stroke.layer = 1;
        return stroke;
    }
    default: {
        core::DrillStroke stroke = randomDrill(document, random);
        stroke.layer = 1; // the layer that a session begins with
        return stroke;
    }
    }
}

/// Two segments that overlap, as if read from a file.
core::ImportMask importOf(const glm::ivec3& size)
{
    core::VoxelRuns low;
    core::VoxelRuns middle;
    const std::uint64_t slice = std::uint64_t(size.x) * std::uint64_t(size.y);
    for (int row = 3; row < size.y - 2; ++row) {
        const std::uint64_t at = slice * 2 + std::uint64_t(row) * std::uint64_t(size.x);
        low.append(at + 1, std::uint64_t(size.x) / 2);
        middle.append(at + std::uint64_t(row), 5);
    }
    middle.append(slice * std::uint64_t(size.z / 2), slice * 2);
    core::ImportMask mask{.file = QStringLiteral("organs.seg.nrrd")};
    mask.size = size;
    mask.segments = {{.name = QStringLiteral("Low"),
                         .rgb = 0x40C080,
                         .code = {},
                         .voxels = core::packedRuns(low)},
        {.name = QStringLiteral("Middle"),
            .rgb = 0xC04080,
            .code = {.scheme = QStringLiteral("SCT"),
                .value = QStringLiteral("10200004"),
                .meaning = QStringLiteral("Liver")},
            .voxels = core::packedRuns(middle)}};
    return mask;
}

/// The same, all of it into segment 1.
core::ImportMask joinedFirst(core::ImportMask mask)
{
    mask.as = core::SegmentWord{.number = 1, .name = {}};
    return mask;
}

/// @param grown edits that leave two segments beside each other
void addChunkCases(std::vector<StrokeCase>& cases, const core::LoadedVolume& volume,
    const std::vector<core::Edit>& grown)
{
    const core::VolumeGeometry& geometry = volume.volume.geometry;
    const auto after = [&grown](std::initializer_list<core::Edit> further) {
        std::vector<core::Edit> all = grown;
        all.insert(all.end(), further);
        return all;
    };
    const auto toggle = [&geometry](int chunks, std::initializer_list<glm::dvec3> voxels) {
        core::ChunkToggle edit{.segment = 1, .chunks = chunks};
        for (const glm::dvec3& voxel : voxels)
            edit.pointsLps.push_back(geometry.toWorld(voxel));
        return edit;
    };
    const core::Chunks near{.segment = 1, .marginMm = 3.0};
    const core::Chunks wide{.segment = 2, .marginMm = 500.0};
    core::ChunkToggle one = toggle(40, {{20, 16, 10}});
    core::ChunkToggle many = toggle(300, {{4, 9, 9}, {20, 16, 12}, {30, 30, 12}, {36, 3, 18}});
    core::ChunkToggle added = many;
    added.mode = core::ChunkToggle::Mode::Add;
    added.overwriteUnlocked = true;
    core::ChunkToggle removed = toggle(2, {{4, 9, 9}, {20, 16, 12}, {30, 30, 12}});
    removed.mode = core::ChunkToggle::Mode::Remove;
    const core::Edit lock = test::lockSegment(2);
    const auto row = std::int64_t(grown.size()) + 2;

    cases.push_back({"divide into chunks", volume, grown, near});
    cases.push_back({"divide again", volume, after({near}), near});
    cases.push_back({"divide otherwise", volume, after({near}), wide});
    cases.push_back({"divide what was changed", volume, after({wide, added}), wide});
    cases.push_back({"toggle a chunk", volume, after({wide}), one});
    cases.push_back({"toggle chunks back", volume, after({wide, many}), many});
    cases.push_back({"add chunks", volume, after({wide}), added});
    cases.push_back({"add chunks beside a locked segment", volume, after({wide, lock}), added});
    cases.push_back({"take chunks", volume, after({wide}), removed});
    cases.push_back({"take what is not there", volume, after({wide, removed}), removed});
    cases.push_back({"toggle by an older division", volume,
        after({wide, one, near, core::RemoveSegment{.segment = 2}}), one});
    cases.push_back({"undo only a chunk", volume,
        after({wide, one, core::AddLayer{.name = QStringLiteral("Other")}}),
        test::revertRows({row})});
    cases.push_back({"growth after chunks", volume, after({wide, removed}),
        core::GrowSteps{.criteria = {.lower = 0, .upper = 1000}, .steps = 3}});
    cases.push_back(
        {"delete what is divided", volume, after({near, one}), core::RemoveSegment{.segment = 1}});
}

} // namespace

StrokeHashes runStroke(core::EditEngine& engine, const StrokeCase& strokeCase)
{
    try {
        return run(engine, strokeCase);
    } catch (const Failure& failure) {
        StrokeHashes hashes;
        hashes.failure = failure.text;
        return hashes;
    }
}

QString contradiction(const StrokeHashes& hashes)
{
    if (!hashes.failure.isEmpty())
        return hashes.failure;
    const std::array<std::tuple<const char*, const QByteArray&, const QByteArray&>, 7> pairs{
        {{"cancelled", hashes.before, hashes.cancelled}, {"undone", hashes.before, hashes.undone},
            {"redone", hashes.finished, hashes.redone},
            {"made again", hashes.finished, hashes.again},
            {"told in pieces", hashes.finished, hashes.inPieces},
            {"reopened", hashes.finished, hashes.reopened},
            {"replayed", hashes.finished, hashes.replayed}}};
    for (const auto& [name, expected, found] : pairs) {
        if (expected.size() != 64)
            return QStringLiteral("no hash");
        if (expected != found)
            return QStringLiteral("%1: %2 expected, %3 found")
                .arg(QLatin1String(name), QString::fromLatin1(expected.left(12)),
                    QString::fromLatin1(found.left(12)));
    }
    return {};
}

QString difference(const StrokeHashes& expected, const StrokeHashes& actual)
{
    for (const StrokeHashes* hashes : {&expected, &actual}) {
        if (const QString text = contradiction(*hashes); !text.isEmpty())
            return text;
    }
    if (expected.before != actual.before)
        return QStringLiteral("the engines part before the edit");
    if (expected.finished != actual.finished)
        return QStringLiteral("the engines part at the edit");
    return {};
}

std::vector<StrokeCase> strokeCases(int randomCount)
{
    std::vector<StrokeCase> cases;
    Random random(31);
    const glm::ivec3 size(40, 33, 21);
    const core::Document document = randomDocument(size, random, false);
    const core::LoadedVolume volume = loaded(document, balls(size, 7, random));
    const core::Edit first = segmentNamed("First");
    const core::Edit second = segmentNamed("Second");
    const core::Edit seeds = randomSeeds(document, 1, random);
    const core::Edit others = randomSeeds(document, 2, random);
    core::DrillStroke drill = randomDrill(document, random);
    drill.layer = 1;
    drill.mask = {.radiusMm = drill.mask.radiusMm};
    drill.mode = core::DrillMode::Limit;
    drill.restore = false;
    drill.hidden.reset();
    const core::Edit lock = test::lockSegment(1);
    core::GrowSteps some{.criteria = {.lower = 0, .upper = 700}, .steps = 5};
    core::GrowSteps all{.criteria = {.lower = 0, .upper = 240}, .steps = {}};
    core::GrowSteps none{.criteria = {.lower = 60000, .upper = 60001}, .steps = {}};
    core::GrowSteps over{
        .criteria = {.lower = 0, .upper = 1000, .overwriteUnlocked = true}, .steps = {}};

    cases.push_back({"add a segment", volume, {}, first});
    cases.push_back(
        {"rename a segment", volume, {first}, test::renameSegment(1, QStringLiteral("Other"))});
    cases.push_back({"lock a segment", volume, {first}, lock});
    cases.push_back(
        {"move a segment", volume, {first, second}, core::MoveSegment{.segment = 1, .place = 2}});
    cases.push_back(
        {"growth beside a locked one", volume, {first, seeds, some, second, others, lock}, over});
    cases.push_back({"seeds", volume, {first}, seeds});
    cases.push_back({"seeds beside seeds", volume, {first, second, seeds}, others});
    core::SeedStroke moved = others.get<core::SeedStroke>();
    moved.segment = 1;
    moved.takenLps = seeds.get<core::SeedStroke>().pointsLps;
    core::SeedStroke taken{1, {}};
    taken.takenLps = {moved.takenLps->front()};
    cases.push_back({"seeds taken away", volume, {first, seeds}, taken});
    cases.push_back({"seeds moved", volume, {first, second, seeds, others}, moved});
    cases.push_back(
        {"seeds that have grown are not taken away", volume, {first, seeds, some}, taken});
    cases.push_back(
        {"growth from seeds that were moved", volume, {first, seeds, moved, taken}, some});
    cases.push_back({"growth in steps", volume, {first, seeds}, some});
    cases.push_back({"growth to closure", volume, {first, seeds, some}, all});
    cases.push_back({"growth of nothing", volume, {first, seeds}, none});
    cases.push_back({"growth of two", volume, {first, seeds, second, others, some}, all});
    cases.push_back({"growth over another", volume, {first, seeds, all, second, others}, over});
    const core::ShrinkSteps three{.steps = 3};
    cases.push_back({"shrinking", volume, {first, seeds, some, all}, three});
    cases.push_back({"shrinking to the seeds", volume, {first, seeds, some}, core::ShrinkSteps{}});
    cases.push_back({"shrinking two", volume, {first, seeds, some, second, others, over}, three});
    cases.push_back({"shrinking beside a locked one", volume,
        {first, seeds, some, second, others, all, lock}, core::ShrinkSteps{.steps = 1}});
    cases.push_back({"shrinking of nothing", volume, {first, seeds}, three});
    const core::ShrinkAt here{
        .pointsLps = others.get<core::SeedStroke>().pointsLps, .onlyHere = false};
    core::ShrinkAt onlyHere = here;
    onlyHere.onlyHere = true;
    core::ShrinkAt openCut = here;
    openCut.barrier = false;
    // Seeds themselves are never taken back.
    core::ShrinkAt besideSeeds = here;
    for (glm::dvec3& point : besideSeeds.pointsLps) {
        glm::dvec3 voxel = glm::round(document.volumes.front().geometry.toIndex(point));
        voxel.x += voxel.x + 1.0 < size.x ? 1.0 : -1.0;
        point = document.volumes.front().geometry.toWorld(voxel);
    }
    const core::PlugLeak plug{.pointLps = here.pointsLps.front()};
    core::GrowSteps guarded = over;
    guarded.guard = {.factor = 1.5, .voxels = 4, .generations = 6};
    cases.push_back({"shrinking here", volume, {first, seeds, over}, here});
    cases.push_back({"shrinking only here", volume, {first, seeds, over}, onlyHere});
    cases.push_back({"shrinking here, cut left open", volume, {first, seeds, over}, openCut});
    cases.push_back({"shrinking beside a locked one, here", volume,
        {first, seeds, some, second, others, all, lock}, besideSeeds});
    cases.push_back({"plugging where nothing is narrow", volume, {first, seeds, over}, plug});
    cases.push_back({"growth after an open cut", volume, {first, seeds, over, openCut}, over});
    cases.push_back({"growth after a shut cut", volume, {first, seeds, over, here}, over});
    cases.push_back({"growth with a guard", volume, {first, seeds}, guarded});
    cases.push_back({"growth with a guard, again", volume, {first, seeds, guarded}, guarded});
    cases.push_back({"growth after shrinking", volume, {first, seeds, all, three}, over});
    cases.push_back({"undo only a shrinking", volume, {first, seeds, all, three, drill},
        test::revertRows({4})});
    const auto interval = [](double lower, double upper) {
        core::ChangeInterval change;
        change.criteria.lower = lower;
        change.criteria.upper = upper;
        return change;
    };
    // Two strokes of a segment, each with statistics of its own.
    core::GrowSteps byStroke{
        .criteria = {.lower = 0, .upper = 1000, .sigmas = 0.75, .perStroke = true}, .steps = 4};
    core::SeedStroke more = others.get<core::SeedStroke>();
    more.segment = 1;
    cases.push_back({"growth by strokes", volume, {first, seeds, more}, byStroke});
    cases.push_back({"growth by strokes of two", volume,
        {first, second, seeds, moved, others, more}, byStroke});
    cases.push_back(
        {"another interval by strokes", volume, {first, seeds, more, byStroke}, interval(0, 700)});
    cases.push_back(
        {"resume by strokes", volume, {first, seeds, byStroke, more}, core::ResumeGrowth{}});
    core::GrowSteps rolling = over;
    rolling.criteria.passage = 2.5 * document.volumes.front().geometry.spacingMm().x;
    cases.push_back({"growth through passages of a width", volume, {first, seeds}, rolling});
    cases.push_back({"growth of two through passages of a width", volume,
        {first, seeds, second, others}, rolling});
    cases.push_back({"passages after growth without", volume, {first, seeds, some}, rolling});
    cases.push_back(
        {"interval through passages", volume, {first, seeds, rolling}, interval(0, 700)});
    cases.push_back({"shrinking what passed", volume, {first, seeds, rolling}, three});
    cases.push_back({"cutting what passed", volume, {first, seeds, rolling}, here});
    cases.push_back({"resume through passages", volume,
        {first, seeds, rolling, core::ShrinkSteps{.steps = 2}, second, others},
        core::ResumeGrowth{}});
    core::ChangeInterval fewSteps = interval(0, 900);
    fewSteps.steps = 3;
    core::ChangeInterval anew = interval(100, 900);
    anew.fromSeeds = true;
    cases.push_back({"wider", volume, {first, seeds, all}, interval(0, 900)});
    cases.push_back({"wider, some steps", volume, {first, seeds, all}, fewSteps});
    cases.push_back({"narrower", volume, {first, seeds, over}, interval(0, 240)});
    cases.push_back(
        {"narrower and wider", volume, {first, seeds, all, interval(100, 600)}, interval(50, 300)});
    cases.push_back({"nothing is left", volume, {first, seeds, all}, interval(60000, 60001)});
    core::ChangeInterval byItself = interval(0, 900);
    byItself.asBefore = false;
    cases.push_back({"seeds that wait come in", volume, {first, seeds}, byItself});
    cases.push_back(
        {"wider, two compete", volume, {first, seeds, second, others, some}, interval(0, 900)});
    cases.push_back({"wider beside a locked one", volume,
        {first, seeds, some, second, others, all, lock}, interval(0, 900)});
    cases.push_back({"anew from the seeds", volume, {first, seeds, all}, anew});
    cases.push_back({"resume", volume, {first, seeds, some}, core::ResumeGrowth{.steps = 4}});
    cases.push_back({"resume after another interval", volume,
        {first, seeds, some, fewSteps, core::ShrinkSteps{.steps = 2}}, core::ResumeGrowth{}});
    cases.push_back({"undo only a change of the interval", volume,
        {first, seeds, all, interval(0, 900), drill}, test::revertRows({4})});
    core::BarrierStroke shut;
    shut.path.radiusMm = 5.0;
    shut.path.pointsLps = {document.volumes.front().geometry.toWorld({4.0, 9.0, 9.0}),
        document.volumes.front().geometry.toWorld({20.0, 16.0, 12.0}),
        document.volumes.front().geometry.toWorld({30.0, 30.0, 12.0})};
    core::BarrierStroke opened = shut;
    opened.erase = true;
    opened.path.radiusMm = 6.0;
    cases.push_back({"barrier", volume, {first, seeds}, shut});
    cases.push_back({"barrier on what has grown", volume, {first, seeds, over}, shut});
    cases.push_back({"growth beside a barrier", volume, {first, seeds, shut}, over});
    cases.push_back({"barrier opened", volume, {first, seeds, shut, over}, opened});
    cases.push_back({"growth through an opened barrier", volume, {first, seeds, shut, over, opened},
        core::ResumeGrowth{}});
    cases.push_back(
        {"interval beside a barrier", volume, {first, seeds, over, shut}, interval(0, 800)});
    cases.push_back({"drill", volume, {}, drill});
    cases.push_back({"drill in a drill", volume, {drill}, drill});
    cases.push_back({"drill on a segment", volume, {first, seeds, all}, drill});
    cases.push_back(
        {"undo only a drill", volume, {first, drill, seeds, all}, test::revertRows({2})});
    cases.push_back({"undo only two growths", volume, {first, seeds, some, all, drill},
        test::revertRows({3, 4})});
    cases.push_back({"undo only what was undone only", volume,
        {first, drill, seeds, test::revertRows({2})}, test::revertRows({4})});

    core::DrillStroke beside = drill;
    beside.mask.radiusMm *= 0.7;
    for (core::PenSample& sample : beside.samples)
        sample.xMm += beside.mask.radiusMm;
    cases.push_back({"revise a drill", volume, {first, drill, seeds, beside, all},
        core::ReviseStroke{.row = 2, .radiusMm = drill.mask.radiusMm * 1.5}});
    cases.push_back({"remove a drill", volume, {drill, beside, drill},
        core::ReviseStroke{.row = 1, .removed = true}});
    cases.push_back({"revise a revised drill", volume,
        {drill, beside, core::ReviseStroke{.row = 1, .removed = true}},
        core::ReviseStroke{.row = 1, .depthMm = 0.5 * drill.depthMm}});

    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    core::PaintStroke paint{.segment = 1};
    paint.path.radiusMm = 5.0;
    paint.path.pointsLps = {geometry.toWorld({4.0, 9.0, 9.0}), geometry.toWorld({20.0, 16.0, 12.0}),
        geometry.toWorld({30.0, 30.0, 12.0})};
    paint.path.lifts = {2}; // the last point is a dab of its own
    core::PaintStroke eraser = paint;
    eraser.erase = true;
    eraser.path.radiusMm = 7.0;
    core::PaintStroke slice = paint;
    slice.path.shape = core::BrushPath::Shape::Disc;
    slice.path.normalLps = geometry.direction()[2];
    slice.seeds = true;
    slice.lower = 200;
    core::PaintStroke taker = slice;
    taker.segment = 2;
    taker.overwriteUnlocked = true;
    core::BrushStroke brush;
    brush.path = paint.path;
    core::BrushStroke back = brush;
    back.restore = true;
    back.path.radiusMm = 3.0;
    cases.push_back({"paint", volume, {first}, paint});
    cases.push_back({"paint on a slice", volume, {first, paint}, slice});
    cases.push_back({"paint over another", volume, {first, second, seeds, all, paint}, taker});
    cases.push_back({"erase what has grown", volume, {first, seeds, all, paint}, eraser});
    cases.push_back({"erase nothing", volume, {first}, eraser});
    cases.push_back({"growth from paint", volume, {first, slice}, all});
    cases.push_back({"growth after erasing", volume, {first, seeds, some, eraser}, all});
    cases.push_back({"undo only paint", volume, {first, paint, drill}, test::revertRows({2})});
    core::PaintStroke dab = paint;
    dab.segment = 2;
    dab.path.radiusMm = 2.0;
    dab.path.lifts.clear();
    dab.path.pointsLps = {geometry.toWorld({34.0, 4.0, 4.0})};
    core::GrowFromSeeds fromSeeds;
    core::GrowFromSeeds within;
    within.box =
        core::GrowBox{geometry.toWorld({3.0, 2.0, 5.0}), geometry.toWorld({90.0, 30.0, 12.0})};
    within.connectivity = 26;
    within.lengthCost = 0.5;
    core::GrowFromSeeds between;
    between.segments = {2, 3};
    between.overwriteUnlocked = true;
    const core::Edit third = segmentNamed("Third");
    core::PaintStroke last = dab;
    last.segment = 3;
    last.path.pointsLps = {geometry.toWorld({5.0, 28.0, 17.0})};
    cases.push_back({"growing from seeds", volume, {first, second, paint, dab}, fromSeeds});
    cases.push_back({"growing from seeds that are sketched", volume, {first, second, seeds, others},
        fromSeeds});
    cases.push_back({"growing from seeds over what has grown", volume,
        {first, second, third, seeds, some, dab, last}, between});
    cases.push_back({"growing from seeds in a box, beside a locked one", volume,
        {first, second, third, paint, dab, last, lock}, within});
    cases.push_back({"growing from seeds again", volume,
        {first, second, paint, dab, fromSeeds, eraser}, fromSeeds});
    cases.push_back({"undo only growing from seeds", volume,
        {first, second, paint, dab, fromSeeds, drill}, test::revertRows({5})});
    cases.push_back(
        {"growth after growing from seeds", volume, {first, second, seeds, dab, fromSeeds}, all});
    cases.push_back({"carve brush", volume, {drill}, brush});
    cases.push_back({"restore", volume, {drill, brush}, back});
    cases.push_back({"restore what is whole", volume, {}, back});
    cases.push_back({"drill after the brush", volume, {brush, back}, drill});
    cases.push_back({"revise a drill below the brush", volume, {drill, brush, back, drill},
        core::ReviseStroke{.row = 1, .radiusMm = drill.mask.radiusMm * 1.5}});
    cases.push_back({"remove a drill below the brush", volume, {drill, brush, back},
        core::ReviseStroke{.row = 1, .removed = true}});
    cases.push_back(
        {"undo only the brush", volume, {first, brush, seeds, all}, test::revertRows({2})});

    core::PeelCut peel;
    peel.view = drill.view;
    peel.polygonMm = {{-12.0, -9.0}, {11.0, -8.0}, {-9.0, 10.0}, {12.0, 11.0}};
    peel.surfaceThreshold = drill.surfaceThreshold;
    core::PeelCut peelBack = peel;
    peelBack.restore = true;
    peelBack.depthMm = 2.5;
    core::ScissorsCut scissors;
    scissors.view = drill.view;
    scissors.polygonMm = {{-6.0, -20.0}, {6.0, -20.0}, {6.0, 20.0}, {-6.0, 20.0}};
    scissors.surfaceThreshold = drill.surfaceThreshold;
    core::ScissorsCut shallow = scissors;
    shallow.depthMm = 5.0;
    core::ScissorsCut layerOnly = scissors;
    layerOnly.firstLayerOnly = true;
    core::DrillStroke drillBack = drill;
    drillBack.restore = true;
    drillBack.depthMm *= 0.5;
    cases.push_back({"peel", volume, {}, peel});
    cases.push_back({"restore by peeling", volume, {drill, peel}, peelBack});
    cases.push_back({"scissors", volume, {drill}, scissors});
    cases.push_back({"scissors to a depth", volume, {}, shallow});
    cases.push_back({"scissors through a layer", volume, {peel}, layerOnly});
    cases.push_back({"restore by drilling", volume, {peel, drill}, drillBack});
    cases.push_back({"undo only a peel", volume, {first, peel, seeds, all}, test::revertRows({2})});
    cases.push_back({"revise a drill below a peel", volume, {drill, peel, drillBack, shallow},
        core::ReviseStroke{.row = 1, .radiusMm = drill.mask.radiusMm * 1.5}});
    cases.push_back({"remove a drill below a peel", volume, {drill, peel, peelBack, drill},
        core::ReviseStroke{.row = 1, .removed = true}});

    core::DrillStroke soft = drill;
    soft.mask.softnessMm = 0.6 * soft.mask.radiusMm;
    cases.push_back({"drill with a soft edge", volume, {}, soft});
    cases.push_back({"soften a drill below others", volume, {drill, peel, brush, drill},
        core::ReviseStroke{.row = 1, .softnessMm = soft.mask.softnessMm}});
    cases.push_back({"revise a brush", volume, {drill, brush, peel, drill},
        core::ReviseStroke{.row = 2, .radiusMm = 8.0}});
    cases.push_back({"remove a restoring brush", volume, {drill, brush, back, shallow},
        core::ReviseStroke{.row = 3, .removed = true}});
    cases.push_back({"revise a peel", volume, {peel, drill, peelBack},
        core::ReviseStroke{.row = 1, .depthMm = 7.0, .throughGaps = true}});
    cases.push_back({"revise a restoring peel", volume, {drill, peel, peelBack, drill},
        core::ReviseStroke{.row = 3, .depthMm = 1.0}});
    cases.push_back({"revise scissors", volume, {shallow, peel, brush},
        core::ReviseStroke{.row = 1, .depthMm = 9.0}});
    cases.push_back({"remove scissors", volume, {drill, scissors, back},
        core::ReviseStroke{.row = 2, .removed = true}});
    cases.push_back({"undo only the revision of a brush", volume,
        {first, brush, core::ReviseStroke{.row = 2, .radiusMm = 8.0}, seeds},
        test::revertRows({3})});
    core::LaserStroke laser;
    laser.view = drill.view;
    laser.mask = drill.mask;
    laser.surfaceThreshold = drill.surfaceThreshold;
    laser.samples = drill.samples;
    laser.depthMm = 4.0;
    core::LaserStroke laserBack = laser;
    laserBack.restore = true;
    laserBack.depthMm = 2.0;
    core::LaserStroke laserClipped = laser;
    laserClipped.hidden = {{{drill.view.targetLps - drill.view.eyeLps, 0.0}}};
    core::HiddenSide& side = laserClipped.hidden->front();
    side.normalLps = -glm::normalize(side.normalLps); // what lies before the target
    side.offsetMm = glm::dot(side.normalLps, drill.view.targetLps);
    core::DrillStroke drillClipped = drill;
    drillClipped.hidden = laserClipped.hidden;
    core::PeelCut peelClipped = peel;
    peelClipped.hidden = laserClipped.hidden;
    core::ScissorsCut scissorsClipped = scissors;
    scissorsClipped.hidden = laserClipped.hidden;
    core::BrushStroke brushClipped = brush;
    brushClipped.hidden = laserClipped.hidden;
    cases.push_back({"laser", volume, {}, laser});
    cases.push_back({"laser in a drill", volume, {drill}, laser});
    cases.push_back({"restore by laser", volume, {laser, drill}, laserBack});
    cases.push_back({"laser of what is not hidden", volume, {laser}, laserClipped});
    cases.push_back({"drill of what is not hidden", volume, {}, drillClipped});
    cases.push_back({"peel of what is not hidden", volume, {}, peelClipped});
    cases.push_back({"scissors of what is not hidden", volume, {}, scissorsClipped});
    cases.push_back({"brush of what is not hidden", volume, {}, brushClipped});
    cases.push_back(
        {"undo only a laser", volume, {first, laser, seeds, all}, test::revertRows({2})});
    cases.push_back({"revise a drill below a laser", volume, {drill, laser, laserBack, shallow},
        core::ReviseStroke{.row = 1, .radiusMm = drill.mask.radiusMm * 1.5}});
    cases.push_back({"revise a laser", volume, {laser, drill, laserBack},
        core::ReviseStroke{.row = 1, .depthMm = 7.0, .softnessMm = 1.5}});
    cases.push_back({"remove a drill below a laser", volume, {drill, laser, drill},
        core::ReviseStroke{.row = 1, .removed = true}});

    core::DrillStroke other = drill;
    other.layer = 2;
    const core::Edit layer = core::AddLayer{.name = QStringLiteral("Other")};
    const core::Edit mute = core::ChangeLayer{.layer = 1, .muted = true};
    const core::Edit bookmark = bookmarkOf(drill);
    cases.push_back(
        {"delete an empty segment", volume, {first, second}, core::RemoveSegment{.segment = 1}});
    cases.push_back({"delete a segment and its seeds", volume, {first, seeds, second, others},
        core::RemoveSegment{.segment = 1}});
    cases.push_back({"delete one of two grown", volume, {first, seeds, second, others, some, all},
        core::RemoveSegment{.segment = 2}});
    cases.push_back({"growth after a deletion", volume,
        {first, seeds, second, others, some, core::RemoveSegment{.segment = 1}}, all});
    cases.push_back({"add after a deletion", volume,
        {first, second, core::RemoveSegment{.segment = 2}}, first});
    cases.push_back({"add a layer", volume, {drill}, layer});
    cases.push_back({"move a layer", volume, {layer}, core::MoveLayer{.layer = 2, .place = 1}});
    cases.push_back({"mute a layer", volume, {layer, drill, other}, mute});
    cases.push_back({"drill over another layer", volume, {layer, drill}, other});
    cases.push_back({"drill through a muted layer", volume, {layer, drill, mute}, other});
    cases.push_back({"drill where a layer is heard again", volume,
        {layer, drill, mute, core::ChangeLayer{.layer = 1, .muted = false}}, other});
    cases.push_back({"bookmark", volume, {drill}, bookmark});

    const core::SegmentChoice toFirst{.segment = 1};
    const core::SegmentChoice toNew{.name = QStringLiteral("Carved"), .rgb = 0x4080C0};
    const core::LayerToSegment carved{.layer = 1, .target = toNew};
    const core::SegmentToLayer cover{.segment = 1, .layer = 2};
    core::SegmentSeen seen{.target = toNew, .lower = 300.0};
    core::SegmentSeen clipped{.target = toFirst, .overwriteUnlocked = true};
    clipped.hidden = {{beyond(geometry.toWorld({20.0, 16.0, 10.0}), {0.3, -0.2, 1.0}),
        beyond(geometry.toWorld({12.0, 16.0, 10.0}), geometry.direction()[0])}};
    const core::MergeLayers merge{.from = 1, .into = 2};
    const core::RemoveLayer removeLayer{.layer = 2};
    cases.push_back({"layer to a new segment", volume, {drill}, carved});
    cases.push_back({"layer to a segment", volume, {first, seeds, all, second, peel},
        core::LayerToSegment{.layer = 1, .target = {.segment = 2}, .overwriteUnlocked = true}});
    cases.push_back({"nothing to a new segment", volume, {layer}, carved});
    cases.push_back({"muted layer to a segment", volume, {layer, drill, mute}, carved});
    cases.push_back({"segment to layer", volume, {first, seeds, some, layer, drill, other}, cover});
    cases.push_back({"empty segment to layer", volume, {first, layer}, cover});
    cases.push_back({"segment what is seen", volume, {first, paint, drill}, seen});
    cases.push_back(
        {"segment what is seen in a clip region", volume, {first, second, taker, peel}, clipped});
    cases.push_back(
        {"nothing is seen", volume, {}, core::SegmentSeen{.target = toNew, .lower = 1e9}});
    const core::ImportMask mask = importOf(geometry.size);
    core::ImportMask joined = mask;
    joined.as = core::SegmentWord{.number = 2, .name = {}};
    joined.overwriteUnlocked = true;
    cases.push_back({"import a mask", volume, {}, mask});
    cases.push_back({"import a mask around what has grown", volume, {first, seeds, some}, mask});
    cases.push_back({"import a mask into a segment", volume, {first, seeds, all, second}, joined});
    cases.push_back({"growth after a mask", volume, {first, seeds, some, joinedFirst(mask)}, all});
    core::ImportMask taking = mask;
    taking.overwriteUnlocked = true;
    cases.push_back({"import a mask twice", volume, {mask}, taking});
    cases.push_back({"a mask that is held already", volume, {mask}, mask});
    cases.push_back(
        {"undo only a mask", volume, {first, joinedFirst(mask), drill}, test::revertRows({2})});
    cases.push_back({"growth after what is seen", volume, {first, seeds, some, seen}, over});
    cases.push_back({"merge layers", volume, {layer, drill, other, brush}, merge});
    cases.push_back({"merge an empty layer", volume, {layer, other}, merge});
    cases.push_back({"delete a layer", volume, {layer, drill, other}, removeLayer});
    cases.push_back({"delete a muted layer", volume,
        {layer, other, core::ChangeLayer{.layer = 2, .muted = true}}, removeLayer});
    cases.push_back({"add a layer after a deletion", volume, {layer, removeLayer}, layer});
    cases.push_back(
        {"solo", volume, {layer, drill, other}, core::ChangeLayer{.layer = 2, .solo = true}});
    cases.push_back({"drill into a solo layer", volume,
        {layer, drill, core::ChangeLayer{.layer = 2, .solo = true}}, other});
    cases.push_back({"undo only a segment to layer", volume,
        {first, seeds, all, layer, cover, lock}, test::revertRows({5})});
    cases.push_back({"undo only a layer to segment", volume,
        {first, drill, core::LayerToSegment{.layer = 1, .target = toFirst}, drillBack},
        test::revertRows({3})});
    cases.push_back({"revise a drill on a carved segment", volume,
        {first, seeds, all, core::SegmentToLayer{.segment = 1, .layer = 1}, drill, beside},
        core::ReviseStroke{.row = 5, .radiusMm = drill.mask.radiusMm * 1.5}});
    cases.push_back({"remove a bookmark", volume, {bookmark}, core::RemoveBookmark{.bookmark = 1}});

    addChunkCases(cases, volume, {first, seeds, some, second, others, some});

    const core::Edit lift = core::CutPiece{.layer = 1, .name = QStringLiteral("Lid")};
    const core::Edit aside = core::ChangePiece{.piece = 1,
        .offsetMm = glm::dvec3(12.5, -3, 0),
        .rotationDegrees = glm::dvec3(0, 30, 0),
        .zoom = 1.5};
    cases.push_back({"piece", volume, {drill}, lift});
    cases.push_back({"move a piece", volume, {drill, lift}, aside});
    cases.push_back({"drill into a piece's layer", volume, {drill, lift, aside}, drill});
    cases.push_back({"pieces home", volume, {drill, lift, aside}, core::SendPiecesHome{}});
    cases.push_back({"remove a piece", volume, {drill, lift}, core::RemovePiece{.piece = 1}});
    cases.push_back({"piece of a segment", volume, {first},
        core::PastePiece{.segment = 1, .name = QStringLiteral("Copy")}});
    cases.push_back({"delete a segment with its piece", volume,
        {first, core::PastePiece{.segment = 1, .name = QStringLiteral("Copy")}},
        core::RemoveSegment{.segment = 1}});

    const core::Edit shield = test::protectSegment(1);
    cases.push_back({"protect a segment", volume, {first}, shield});
    cases.push_back(
        {"drill beside a protected segment", volume, {first, seeds, all, shield}, drill});
    cases.push_back(
        {"restore a protected segment", volume, {first, seeds, all, drill, shield}, [&drill] {
             core::DrillStroke filled = drill;
             filled.restore = true;
             return filled;
         }()});
    const core::AddMeasurement length{
        .fromLps = glm::dvec3(1, 2, 3), .toLps = glm::dvec3(4, 6, 3), .piece = {}};
    core::AddMeasurement onPiece = length;
    onPiece.piece = 1;
    cases.push_back({"measure", volume, {}, length});
    cases.push_back({"measure on a piece", volume, {drill, lift}, onPiece});
    cases.push_back(
        {"remove a measurement", volume, {length}, core::RemoveMeasurement{.measurement = 1}});

    for (StrokeCase& surface : surfaceCases())
        cases.push_back(std::move(surface));

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomLists(number));
    for (int number = 0; number < randomCount; ++number) {
        Random own(std::uint32_t(700 + number));
        const glm::ivec3 extent{
            randomInt(own, 3, 40), randomInt(own, 3, 40), randomInt(own, 3, 30)};
        const core::Document scene = randomDocument(extent, own, number % 2);
        StrokeCase made{"random stroke " + QByteArray::number(number),
            loaded(scene, number % 3 ? balls(extent, 5, own) : shells(extent)),
            {first, second, randomSeeds(scene, 1, own)}, randomEdit(scene, own)};
        for (int i = randomInt(own, 0, 3); i > 0; --i)
            made.before.push_back(randomEdit(scene, own));
        cases.push_back(std::move(made));
    }
    return cases;
}

} // namespace test
