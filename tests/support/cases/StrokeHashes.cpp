// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/StrokeHashes.h"

#include "core/edits/EditTask.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/SurfaceEdit.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "tests/support/scenes/CutEdits.h"

#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>
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

/// Of one point of a path, as the pen tells it.
std::vector<double> pressuresAt(const core::PenPressures& pressures, std::size_t point)
{
    return pressures ? std::vector<double>{(*pressures)[point]} : std::vector<double>();
}

/// As the pen tells a stroke and the panel a growth; nothing for edits that are made at once.
bool tellInPieces(EditSession& session, const core::Edit& edit, core::Ending ending)
{
    if (const std::vector<core::PenSample>* told = core::penSamplesOf(edit)) {
        const std::vector<core::PenSample>& samples = *told;
        require(session.begin(begunStroke(edit)), "begin");
        for (std::size_t first = 0; first < samples.size(); first += 2) {
            const std::size_t last = std::min(first + 2, samples.size());
            session.extend(core::PenSamples{.samples = {samples.begin() + std::ptrdiff_t(first),
                                                samples.begin() + std::ptrdiff_t(last)}});
            session.poll();
        }
    } else if (const core::BrushPath* way = core::brushPathOf(edit)) {
        const core::BrushPath& whole = *way;
        core::Edit first = edit;
        core::BrushPath& path = *core::brushPathOf(first);
        const std::vector<glm::dvec3>& points = whole.pointsLps;
        path.pointsLps.resize(1);
        path.lifts.clear();
        if (path.pressures)
            path.pressures->resize(1);
        require(session.begin(first), "begin");
        for (std::size_t next = 1; next < points.size(); ++next) {
            session.extend(core::PathPoints{.pointsLps = {points[next]},
                .lifted = std::find(whole.lifts.begin(), whole.lifts.end(), std::int64_t(next))
                    != whole.lifts.end(),
                .pressures = pressuresAt(whole.pressures, next)});
            session.poll();
        }
    } else if (const core::SurfacePath* surface = core::surfacePathOf(edit)) {
        core::Edit first = edit;
        core::surfacePathOf(first)->pointsLps.resize(1);
        if (core::PenPressures& pressures = core::surfacePathOf(first)->pressures)
            pressures->resize(1);
        require(session.begin(first), "begin");
        for (std::size_t next = 1; next < surface->pointsLps.size(); ++next) {
            session.extend(core::PathPoints{.pointsLps = {surface->pointsLps[next]},
                .pressures = pressuresAt(surface->pressures, next)});
            session.poll();
        }
    } else if (const auto* peel = edit.as<core::PeelCut>()) {
        core::PeelCut first = *peel;
        first.depthMm = std::min(2.0 * peel->depthMm + 1.0, 60.0);
        require(session.begin(first), "begin");
        for (const double depthMm : {1.0, 0.0, 0.5 * peel->depthMm, peel->depthMm}) {
            session.extend(core::ToDepth{depthMm});
            session.poll();
        }
    } else if (const auto* change = edit.as<core::ChangeInterval>()) {
        // As a slider is dragged.
        core::ChangeInterval first = *change;
        first.criteria.upper += 200.0;
        require(session.begin(first), "begin");
        session.extend(core::GrowAdvance{});
        session.poll();
        session.extend(core::ToInterval{
            .lower = change->criteria.lower - 100.0, .upper = change->criteria.upper});
        session.extend(core::GrowAdvance{});
        session.poll();
        session.extend(
            core::ToInterval{.lower = change->criteria.lower, .upper = change->criteria.upper});
        session.extend(
            core::GrowAdvance{.steps = change->steps.value_or(core::GrowAdvance::toClosure)});
    } else if (const auto* resume = edit.as<core::ResumeGrowth>()) {
        require(session.begin(*resume), "begin");
        session.extend(
            core::GrowAdvance{.steps = resume->steps.value_or(core::GrowAdvance::toClosure)});
    } else if (const auto* shrink = edit.as<core::ShrinkAt>(); shrink && shrink->steps) {
        // As it is held.
        core::ShrinkAt first = *shrink;
        first.steps = 1;
        require(session.begin(first), "begin");
        for (int steps = 1; steps <= *shrink->steps; ++steps) {
            session.extend(core::ToSteps{steps});
            session.poll();
        }
    } else if (edit.is<core::GrowFromSeeds>()) {
        require(session.begin(edit), "begin");
        // Whatever else is done takes a preview back, and the next goes on from what it found.
        session.closeOpen();
        session.poll();
        require(session.begin(edit), "begin again");
        session.poll();
    } else if (const auto* threshold = edit.as<core::ThresholdSegment>()) {
        // As a bound is dragged: every move begins it anew.
        core::ThresholdSegment first = *threshold;
        first.lower.reset();
        require(session.begin(first), "begin");
        session.poll();
        session.end(core::Ending::Rollback);
        require(session.begin(edit), "begin again");
        // Whatever else is done takes it back.
        session.closeOpen();
        session.poll();
        require(session.begin(edit), "begin once more");
        session.poll();
    } else if (edit.is<core::InvertSegment>() || edit.is<core::CombineSegments>()) {
        require(session.begin(edit), "begin");
        session.closeOpen();
        session.poll();
        require(session.begin(edit), "begin again");
        session.poll();
    } else if (core::taskOf(edit) == core::EditTask::Islands && core::canStandOpen(edit)) {
        // What is worked out is dropped on the way, and once it is seen.
        require(session.begin(edit), "begin");
        session.poll();
        session.closeOpen();
        require(session.begin(edit), "begin again");
        while (session.openEdit() && !session.openHasBegun())
            session.poll();
        session.end(core::Ending::Rollback);
        require(session.begin(edit), "begin once more");
        session.poll();
    } else if (edit.is<core::GrowSteps>()) {
        require(session.begin(edit), "begin");
        const int steps = core::growStepsOf(edit)->value_or(core::GrowAdvance::toClosure);
        if (steps > 1) {
            session.extend(core::GrowAdvance{.steps = 1});
            session.poll();
            session.extend(core::GrowAdvance{.steps = steps - 1});
        } else {
            session.extend(core::GrowAdvance{.steps = steps});
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

StrokeEnds strokeEnds(core::EditEngine& engine, const StrokeCase& strokeCase)
{
    StrokeEnds ends;
    try {
        const auto session = begun(engine, strokeCase, {});
        ends.before = settledHash(*session);
        require(session->apply(strokeCase.edit), "apply");
        ends.finished = settledHash(*session);
    } catch (const Failure& failure) {
        ends.failure = failure.text;
    }
    return ends;
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

QString difference(const StrokeEnds& expected, const StrokeHashes& actual)
{
    if (!expected.failure.isEmpty())
        return expected.failure;
    if (const QString text = contradiction(actual); !text.isEmpty())
        return text;
    if (expected.before != actual.before)
        return QStringLiteral("the engines part before the edit");
    if (expected.finished != actual.finished)
        return QStringLiteral("the engines part at the edit");
    return {};
}

} // namespace test
