// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/sessions/SessionScript.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace test {

namespace {

using core::RowId;

/// At 120 Hz: some seconds of a pen, enough for a transaction of a hundred kilobytes.
core::Edit longDrill(Random& random)
{
    core::Edit stroke = drillAt(-8.0 + 16.0 * randomUnit(random));
    std::vector<core::PenSample>& path = *core::penSamplesOf(stroke);
    const core::PenSample first = path.front();
    const int samples = randomInt(random, 400, 1600);
    const double turn = 0.002 + 0.01 * randomUnit(random);
    path.clear();
    for (int i = 0; i < samples; ++i)
        path.push_back({.xMm = first.xMm + 4.0 * std::sin(turn * i),
            .yMm = first.yMm + 4.0 * std::sin(1.7 * turn * i),
            .pressure = 0.4 + 0.6 * randomUnit(random),
            .tSeconds = i / 120.0});
    return stroke;
}

core::Edit randomEdit(const core::History& history, Random& random)
{
    const int lot = randomInt(random, 0, 99);
    const int segment = randomInt(random, 1, 2);
    if (lot < 30)
        return drillAt(-12.0 + 24.0 * randomUnit(random));
    if (lot < 40)
        return longDrill(random);
    if (lot < 55)
        return segment == 1 ? growBrain(randomInt(random, 1, 3))
                            : growBone(randomInt(random, 1, 4));
    if (lot < 65)
        return segment == 1 ? seedInBrain(1) : seedInBone(2);
    if (lot < 75)
        return test::renameSegment(
            segment, QStringLiteral("Name %1").arg(randomInt(random, 1, 1000)));
    if (lot < 80)
        return core::MoveSegment{.segment = segment, .place = randomInt(random, 1, 2)};
    if (lot < 83)
        return addSegment("Another");
    // Mostly the newest rows can be taken back on their own.
    const auto last = RowId(history.rows().size());
    const int back = std::min(randomInt(random, 0, 6), int(last) - 1);
    return test::revertRows({std::max<RowId>(last - back, 1)});
}

core::RecipeStep randomStep(const core::History& history, Random& random)
{
    using Kind = core::HistoryMove::Kind;
    const int lot = randomInt(random, 0, 99);
    if (lot < 12 && history.canUndo())
        return core::HistoryMove{.kind = Kind::Undo};
    if (lot < 20 && history.canRedo())
        return core::HistoryMove{.kind = Kind::Redo};
    if (lot < 28)
        return core::HistoryMove{
            .kind = Kind::GoTo, .row = randomInt(random, 0, int(history.rows().size()))};
    return core::quantised(randomEdit(history, random));
}

bool carriedOut(const core::RecipeStep& step, core::EditSession& session)
{
    const auto rows = session.history().rows().size();
    const RowId position = session.history().position();
    core::Result<void> begun;
    if (const auto* edit = std::get_if<core::Edit>(&step)) {
        begun = session.apply(*edit);
    } else {
        const auto& move = std::get<core::HistoryMove>(step);
        begun = move.kind == core::HistoryMove::Kind::Undo ? session.undo()
            : move.kind == core::HistoryMove::Kind::Redo   ? session.redo()
                                                           : session.goTo(move.row);
    }
    // What is refused, or changes nothing, is no part of the script.
    return begun && session.settle()
        && (session.history().rows().size() > rows || session.history().position() != position);
}

} // namespace

RowId SessionScript::rowsAfter(std::size_t done) const
{
    return done == 0 ? 0 : steps[done - 1].rows;
}

RowId SessionScript::positionAfter(std::size_t done) const
{
    return done == 0 ? 0 : steps[done - 1].position;
}

std::set<RowId> SessionScript::positionsFrom(std::size_t done) const
{
    std::set<RowId> positions{positionAfter(done)};
    if (done == steps.size())
        return positions;
    RowId from = positionAfter(done);
    RowId to = positionAfter(done + 1);
    positions.insert(to);
    // Parents have lower numbers: the higher of both climbs until they meet.
    while (from != to) {
        RowId& higher = from > to ? from : to;
        higher = parents[std::size_t(higher)];
        positions.insert(higher);
    }
    return positions;
}

QByteArray SessionScript::recipe() const
{
    QJsonArray list;
    for (const Step& step : steps) {
        if (const auto* edit = std::get_if<core::Edit>(&step.step)) {
            list.append(core::editToJson(*edit));
            continue;
        }
        const auto& move = std::get<core::HistoryMove>(step.step);
        QJsonObject object{{QStringLiteral("edit"), core::stepName(step.step)}};
        if (move.kind == core::HistoryMove::Kind::GoTo)
            object[QStringLiteral("seq")] = qint64(move.row);
        list.append(object);
    }
    return QJsonDocument(QJsonObject{{QStringLiteral("edits"), list}}).toJson();
}

SessionScript randomScript(const core::LoadedVolume& volume, Random& random, int steps)
{
    reference::ReferenceEngine oracle;
    const auto session = core::EditSession::create(oracle, volume, {});
    if (!session)
        qFatal("the oracle takes no volume");
    const core::History& history = (*session)->history();
    std::vector<core::RecipeStep> start{core::quantised(addSegment("Brain")),
        core::quantised(addSegment("Skull")), core::quantised(seedInBrain(1)),
        core::quantised(seedInBone(2))};

    SessionScript script;
    script.hashes = {(*session)->stateHash()};
    script.parents = {0};
    while (int(script.steps.size()) < steps) {
        const std::size_t number = script.steps.size();
        const core::RecipeStep step =
            number < start.size() ? start[number] : randomStep(history, random);
        if (!carriedOut(step, **session))
            continue;
        if (history.rows().size() + 1 > script.hashes.size()) {
            script.hashes.push_back(history.rows().back().stateHash);
            script.parents.push_back(history.rows().back().parent);
        }
        script.steps.push_back(
            {.step = step, .rows = RowId(history.rows().size()), .position = history.position()});
    }
    script.line = history.line();
    return script;
}

} // namespace test
