// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineConformance.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

namespace test {

namespace {

constexpr std::uint8_t highestPlane = 2;

QString describe(const core::BrickKey& key)
{
    static const std::array<const char*, 5> names{
        "?", "coverage", "labels", "seed words", "beneath"};
    return QStringLiteral("%1 of plane %2, brick %3")
        .arg(QLatin1String(names.at(std::size_t(key.field))))
        .arg(key.plane)
        .arg(key.brick);
}

QString differenceOfBricks(
    const std::vector<core::BrickChange>& expected, const std::vector<core::BrickChange>& actual)
{
    for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i) {
        const core::BrickChange& a = expected[i];
        const core::BrickChange& b = actual[i];
        if (a.key != b.key)
            return QStringLiteral("expected %1, found %2").arg(describe(a.key), describe(b.key));
        for (const auto& [which, x, y] : {std::tuple{"before", &a.before.read(), &b.before.read()},
                 std::tuple{"after", &a.after.read(), &b.after.read()}}) {
            if (x->size() != y->size())
                return QStringLiteral("%1, %2: %3 bytes expected, %4 found")
                    .arg(describe(a.key), QLatin1String(which))
                    .arg(x->size())
                    .arg(y->size());
            const auto parting = std::mismatch(x->begin(), x->end(), y->begin());
            if (parting.first != x->end())
                return QStringLiteral("%1, %2, byte %3: %4 expected, %5 found")
                    .arg(describe(a.key), QLatin1String(which))
                    .arg(parting.first - x->begin())
                    .arg(*parting.first)
                    .arg(*parting.second);
        }
    }
    if (expected.size() != actual.size())
        return QStringLiteral("%1 bricks expected, %2 found")
            .arg(expected.size())
            .arg(actual.size());
    return {};
}

/// The XOR of both images of a change.
core::BrickImage differenceOf(const core::BrickChange& change)
{
    const core::Field field = change.key.field;
    const std::size_t size =
        std::size_t(core::BrickGrid::voxelsPerBrick * core::bytesPerVoxel(field));
    const std::vector<std::uint8_t> empty(size, core::emptyByte(field));
    const std::vector<std::uint8_t>& before = change.before.empty() ? empty : change.before.read();
    const std::vector<std::uint8_t>& after = change.after.empty() ? empty : change.after.read();
    std::vector<std::uint8_t> difference(size);
    for (std::size_t i = 0; i < size; ++i)
        difference[i] = before[i] ^ after[i];
    return {change.key, std::move(difference)};
}

/// Runs a case and keeps the books that a session would keep.
class Runner {
public:
    Runner(core::EditEngine& engine, const EngineCase& engineCase)
        : m_engine(engine)
        , m_size(engineCase.codes.size)
    {
    }

    EngineOutcome run(const EngineCase& engineCase)
    {
        m_engine.finish();
        (void)m_engine.collect();
        const auto opened = m_engine.openVolume(m_size, engineCase.codes.values);
        if (!opened) {
            complain(QStringLiteral("openVolume: ")
                + opened.error().arguments.join(QStringLiteral(": ")));
            return std::move(m_outcome);
        }
        for (const EngineStep& step : engineCase.steps)
            std::visit([this](const auto& known) { carryOut(known); }, step);
        settle();
        readState();
        return std::move(m_outcome);
    }

private:
    /// A committed edit: what undo needs.
    struct Entry {
        std::size_t command = 0;
        std::optional<std::uint8_t> growthPlane;
        std::uint32_t generationBefore = 0;
        std::uint32_t generationAfter = 0;
    };

    std::size_t submit(core::EngineCommand command)
    {
        const core::Ticket ticket = m_engine.submit(std::move(command));
        if (m_lastTicket && ticket != *m_lastTicket + 1)
            complain(QStringLiteral("tickets do not grow by one"));
        m_lastTicket = ticket;
        m_places[ticket] = m_commands;
        take();
        return m_commands++;
    }

    void take()
    {
        for (core::EngineResult& result : m_engine.collect()) {
            const auto place = m_places.find(result.ticket);
            if (place == m_places.end()) {
                complain(QStringLiteral("a result for a command that has had one"));
                continue;
            }
            result.ticket = place->second;
            m_places.erase(place);
            if (!m_outcome.results.empty() && m_outcome.results.back().ticket >= result.ticket)
                complain(QStringLiteral("results out of order"));
            m_outcome.results.push_back(std::move(result));
        }
    }

    void settle()
    {
        m_engine.finish();
        take();
        for (Entry& entry : m_history) {
            if (!entry.growthPlane || !m_read.insert(entry.command).second)
                continue;
            const core::EngineResult result = resultOf(entry.command);
            if (result.error) {
                entry.growthPlane.reset();
                continue;
            }
            entry.generationAfter = result.generation;
            m_generations[*entry.growthPlane] = result.generation;
        }
    }

    core::EngineResult resultOf(std::size_t command)
    {
        for (const core::EngineResult& result : m_outcome.results) {
            if (result.ticket == command)
                return result;
        }
        complain(QStringLiteral("no result for command %1").arg(command));
        return {};
    }

    void carryOut(const core::EngineCommand& command)
    {
        if (const auto* begin = std::get_if<core::BeginEdit>(&command)) {
            const auto* growth = std::get_if<core::GrowBurst>(&begin->edit);
            const auto* shrink = std::get_if<core::ShrinkGrowth>(&begin->edit);
            const auto* cut = std::get_if<core::CutGrowth>(&begin->edit);
            m_opening = {};
            if (cut) {
                m_opening.growthPlane = cut->plane;
                m_opening.generationBefore = cut->generation;
            }
            if (shrink) {
                m_opening.growthPlane = shrink->plane;
                m_opening.generationBefore = shrink->generation;
            }
            if (growth) {
                m_opening.growthPlane = growth->plane;
                m_opening.generationBefore = growth->generation;
            }
            m_isOpen = true;
        }
        const auto* extend = std::get_if<core::ExtendEdit>(&command);
        const auto* anew = extend ? std::get_if<core::GrowAnew>(&extend->extension) : nullptr;
        std::size_t place = 0;
        if (anew) {
            core::GrowBurst burst = anew->burst;
            burst.generation = m_opening.generationBefore;
            place = submit(core::ExtendEdit{core::GrowAnew{std::move(burst)}});
        } else {
            place = submit(command);
        }
        const auto* end = std::get_if<core::EndEdit>(&command);
        if (end && m_isOpen && end->ending == core::Ending::Commit) {
            m_history.resize(m_undone, m_opening);
            m_opening.command = place;
            m_history.push_back(m_opening);
            m_undone = m_history.size();
        }
        if (end)
            m_isOpen = false;
    }

    void carryOut(const BeginGrowth& begin)
    {
        settle();
        core::GrowBurst burst = begin.burst;
        burst.generation = m_generations[burst.plane];
        carryOut(core::EngineCommand(core::BeginEdit{std::move(burst)}));
    }

    void carryOut(const Shrink& step)
    {
        settle();
        core::ShrinkGrowth shrink = step.shrink;
        shrink.generation = m_generations[shrink.plane];
        shrink.keepSeeds = !step.generations || *step.generations >= shrink.generation;
        shrink.keep = shrink.keepSeeds ? 0 : shrink.generation - *step.generations;
        carryOut(core::EngineCommand(core::BeginEdit{shrink}));
        for (const std::uint32_t keep : step.then) {
            carryOut(core::EngineCommand(
                core::ExtendEdit{core::ShrinkTo{keep % (shrink.generation + 1)}}));
            submit(core::ReadBricks{
                {{core::Field::Labels, shrink.plane, 0}, {core::Field::SeedWords, shrink.plane, 0},
                    {core::Field::Overwritten, shrink.plane, 0}}});
            submit(core::CountGenerations{shrink.plane});
        }
        carryOut(core::EngineCommand(core::EndEdit{step.ending}));
    }

    void carryOut(const Cut& step)
    {
        settle();
        core::CutGrowth cut = step.cut;
        cut.generation = m_generations[cut.plane];
        const std::vector<core::BrickChange> before = bricksOfGrowth(cut.plane);
        const bool wasOpen = m_isOpen;
        const std::size_t question = submit(core::PreviewCut{cut});
        settle();
        // A look ahead changes nothing, and takes what the cut then takes.
        if (!differenceOfBricks(before, bricksOfGrowth(cut.plane)).isEmpty())
            complain(QStringLiteral("foreseeing a cut changed something"));
        carryOut(core::EngineCommand(core::BeginEdit{cut}));
        for (const std::uint32_t steps : step.then) {
            carryOut(core::EngineCommand(core::ExtendEdit{core::CutFurther{steps}}));
            settle();
            m_outcome.progress.push_back(m_engine.growthProgress());
            submit(core::ReadBricks{{{core::Field::Labels, cut.plane, 0},
                {core::Field::SeedWords, cut.plane, 0}, {core::Field::Overwritten, cut.plane, 0}}});
            submit(core::CountGenerations{cut.plane});
        }
        const std::size_t end = m_commands;
        carryOut(core::EngineCommand(core::EndEdit{step.ending}));
        submit(core::ReadBarriers{cut.plane}); // a cut may leave some
        settle();
        const core::EngineResult cutPreview = resultOf(question);
        const core::EngineResult done = resultOf(end);
        if (cutPreview.error.has_value() != (done.error.has_value() || wasOpen))
            complain(QStringLiteral("what is foreseen and what is done are not refused alike"));
        else if (!cutPreview.error && step.ending == core::Ending::Commit && step.then.empty())
            compareWithForeseen(cutPreview, done);
    }

    void compareWithForeseen(const core::EngineResult& cutPreview, const core::EngineResult& done)
    {
        if (!cutPreview.cutPreview)
            return complain(QStringLiteral("a cut was not foreseen"));
        std::vector<core::CutPreview::Brick> taken;
        for (const core::BrickChange& change : done.changes) {
            if (change.key.field != core::Field::Labels)
                continue;
            core::CutPreview::Brick& brick = taken.emplace_back();
            brick.brick = change.key.brick;
            for (std::size_t voxel = 0; voxel < change.before.size(); ++voxel) {
                const int now = change.after.empty() ? 0 : change.after.read()[voxel];
                brick.taken[voxel] = change.before.read()[voxel] != now;
            }
        }
        if (taken != cutPreview.cutPreview->bricks
            || done.statistics.voxelsChanged != cutPreview.cutPreview->voxels)
            complain(QStringLiteral("a cut took %1 voxels where %2 were foreseen")
                         .arg(done.statistics.voxelsChanged)
                         .arg(cutPreview.cutPreview->voxels));
        if ((cutPreview.cutPreview->members == 0) != done.changes.empty())
            complain(QStringLiteral("whether a cut does anything was foreseen wrongly"));
    }

    /// Words and labels, asked aside: no result of the case.
    std::vector<core::BrickChange> bricksOfGrowth(std::uint8_t plane)
    {
        core::ReadBricks read;
        const core::BrickGrid grid{m_size};
        for (const auto field :
            {core::Field::Labels, core::Field::SeedWords, core::Field::Overwritten}) {
            for (int brick = 0; brick < grid.brickCount(); ++brick)
                read.keys.push_back({field, plane, std::uint32_t(brick)});
        }
        return resultOf(submitAndSettle(std::move(read))).changes;
    }
    std::size_t submitAndSettle(core::EngineCommand command)
    {
        const std::size_t place = submit(std::move(command));
        settle();
        return place;
    }

    void carryOut(const Undo&)
    {
        settle();
        if (m_undone == 0)
            return;
        const Entry& entry = m_history[--m_undone];
        swap(entry, false);
        if (entry.growthPlane)
            m_generations[*entry.growthPlane] = entry.generationBefore;
    }

    void carryOut(const Redo&)
    {
        settle();
        if (m_undone == m_history.size())
            return;
        const Entry& entry = m_history[m_undone++];
        swap(entry, true);
        if (entry.growthPlane)
            m_generations[*entry.growthPlane] = entry.generationAfter;
    }

    /// Back as a session does while bricks are at hand, forward as it does from the disk.
    void swap(const Entry& entry, bool forward)
    {
        core::SwapBricks swap;
        core::XorBricks lay;
        for (const core::BrickChange& change : resultOf(entry.command).changes) {
            swap.bricks.push_back({change.key, change.before});
            lay.differences.push_back(differenceOf(change));
        }
        if (forward)
            submit(std::move(lay));
        else
            submit(std::move(swap));
    }

    void carryOut(const Settle&)
    {
        settle();
        const core::GrowthProgress progress = m_engine.growthProgress();
        if (progress.open)
            m_outcome.progress.push_back(progress);
        if (progress.running)
            complain(QStringLiteral("a growth still runs after finish()"));
    }

    void readState()
    {
        core::ReadBricks read;
        const core::BrickGrid grid{m_size};
        for (const auto field : {core::Field::Coverage, core::Field::Labels, core::Field::SeedWords,
                 core::Field::Overwritten}) {
            for (int plane = 0; plane <= highestPlane; ++plane) {
                for (int brick = 0; brick < grid.brickCount(); ++brick)
                    read.keys.push_back({field, std::uint8_t(plane), std::uint32_t(brick)});
            }
        }
        m_engine.submit(read);
        m_engine.finish();
        const std::vector<core::EngineResult> results = m_engine.collect();
        if (results.size() != 1 || results.front().changes.size() != read.keys.size()) {
            complain(QStringLiteral("the state cannot be read"));
            return;
        }
        m_outcome.state = results.front().changes;
        std::erase_if(
            m_outcome.state, [](const core::BrickChange& brick) { return brick.after.empty(); });
    }

    void complain(const QString& text)
    {
        if (m_outcome.failure.isEmpty())
            m_outcome.failure = text;
    }

    core::EditEngine& m_engine;
    glm::ivec3 m_size;
    EngineOutcome m_outcome;
    std::optional<core::Ticket> m_lastTicket;
    std::map<core::Ticket, std::size_t> m_places;
    std::size_t m_commands = 0;
    std::map<std::uint8_t, std::uint32_t> m_generations;
    std::set<std::size_t> m_read; ///< entries whose generation is taken in
    std::vector<Entry> m_history;
    std::size_t m_undone = 0; ///< entries before this one are in force
    Entry m_opening;
    bool m_isOpen = false;
};

QString differenceOfResults(const core::EngineResult& a, const core::EngineResult& b)
{
    const auto number = [](const char* name, auto expected, auto actual) {
        return expected == actual ? QString()
                                  : QStringLiteral("%1: %2 expected, %3 found")
                                        .arg(QLatin1String(name))
                                        .arg(expected)
                                        .arg(actual);
    };
    if (a.error.has_value() != b.error.has_value())
        return a.error ? QStringLiteral("an error was expected (%1)")
                             .arg(a.error->arguments.join(QStringLiteral(": ")))
                       : QStringLiteral("unexpected error (%1)")
                             .arg(b.error->arguments.join(QStringLiteral(": ")));
    if (a.error && a.error->code != b.error->code)
        return QStringLiteral("another error code");
    const std::array<QString, 11> texts{differenceOfBricks(a.changes, b.changes),
        number("voxelsChanged", a.statistics.voxelsChanged, b.statistics.voxelsChanged),
        number("bricks", a.statistics.bricks, b.statistics.bricks),
        number("generations", a.statistics.generations, b.statistics.generations),
        a.statistics.searchedTo == b.statistics.searchedTo
            ? QString()
            : QStringLiteral("the surface was looked for to another depth"),
        number("generation", a.generation, b.generation),
        number("atClosure", int(a.atClosure), int(b.atClosure)),
        a.alarm == b.alarm ? QString() : QStringLiteral("another alarm"),
        number("probes", a.probes.size(), b.probes.size()),
        number("picks", a.picks.size(), b.picks.size()),
        a.seeds == b.seeds ? QString() : QStringLiteral("other sums around the seeds")};
    for (const QString& text : texts) {
        if (!text.isEmpty())
            return text;
    }
    if (a.codes != b.codes)
        return QStringLiteral("other codes of a box");
    if (a.generationSizes != b.generationSizes)
        return QStringLiteral("members of generations differ");
    if (a.tolerance != b.tolerance)
        return QStringLiteral("another curve of tolerances");
    if (a.cutPreview != b.cutPreview)
        return QStringLiteral("another cut is foreseen");
    if (a.growthComparison != b.growthComparison)
        return QStringLiteral("a growth differs otherwise from its beginning");
    for (std::size_t i = 0; i < a.probes.size(); ++i) {
        if (a.probes[i].code != b.probes[i].code || a.probes[i].label != b.probes[i].label)
            return QStringLiteral("probe %1 reads %2, %3 instead of %4, %5")
                .arg(i)
                .arg(b.probes[i].code)
                .arg(b.probes[i].label)
                .arg(a.probes[i].code)
                .arg(a.probes[i].label);
        if (a.probes[i].labels != b.probes[i].labels)
            return QStringLiteral("probe %1 reads other labels of all planes").arg(i);
        if (a.probes[i].seedOf != b.probes[i].seedOf)
            return QStringLiteral("probe %1 reads a seed of %2 instead of %3")
                .arg(i)
                .arg(b.probes[i].seedOf)
                .arg(a.probes[i].seedOf);
        if (a.probes[i].tolerance != b.probes[i].tolerance)
            return QStringLiteral("probe %1 reads tolerance %2 instead of %3")
                .arg(i)
                .arg(b.probes[i].tolerance.value_or(-1))
                .arg(a.probes[i].tolerance.value_or(-1));
    }
    const auto place = [](const std::optional<glm::ivec3>& voxel) {
        return voxel ? QStringLiteral("(%1, %2, %3)").arg(voxel->x).arg(voxel->y).arg(voxel->z)
                     : QStringLiteral("nothing");
    };
    for (std::size_t i = 0; i < a.picks.size(); ++i) {
        if (a.picks[i] != b.picks[i])
            return QStringLiteral("ray %1 finds %2 instead of %3")
                .arg(i)
                .arg(place(b.picks[i]), place(a.picks[i]));
    }
    return {};
}

bool equal(const core::GrowthProgress& a, const core::GrowthProgress& b)
{
    return a.atClosure == b.atClosure && a.generation == b.generation && a.members == b.members
        && a.frontSizes == b.frontSizes && a.alarm == b.alarm && a.backwards == b.backwards;
}

} // namespace

EngineOutcome runCase(core::EditEngine& engine, const EngineCase& engineCase)
{
    return Runner(engine, engineCase).run(engineCase);
}

QString difference(const EngineOutcome& expected, const EngineOutcome& actual)
{
    for (const EngineOutcome* outcome : {&expected, &actual}) {
        if (!outcome->failure.isEmpty())
            return outcome->failure;
    }
    for (std::size_t i = 0; i < std::min(expected.results.size(), actual.results.size()); ++i) {
        const core::EngineResult& a = expected.results[i];
        const core::EngineResult& b = actual.results[i];
        if (a.ticket != b.ticket)
            return QStringLiteral("command %1 should have a result, not %2")
                .arg(a.ticket)
                .arg(b.ticket);
        if (const QString text = differenceOfResults(a, b); !text.isEmpty())
            return QStringLiteral("result of command %1: %2").arg(a.ticket).arg(text);
    }
    if (expected.results.size() != actual.results.size())
        return QStringLiteral("%1 results expected, %2 found")
            .arg(expected.results.size())
            .arg(actual.results.size());
    if (!std::equal(expected.progress.begin(), expected.progress.end(), actual.progress.begin(),
            actual.progress.end(), equal))
        return QStringLiteral("the growth progress tells otherwise");
    if (const QString text = differenceOfBricks(expected.state, actual.state); !text.isEmpty())
        return QStringLiteral("state at the end: ") + text;
    return {};
}

void appendWhole(std::vector<EngineStep>& steps, core::EngineEdit edit,
    std::vector<core::EngineExtension> extensions, core::Ending ending)
{
    steps.push_back(core::EngineCommand(core::BeginEdit{std::move(edit)}));
    for (core::EngineExtension& extension : extensions)
        steps.push_back(core::EngineCommand(core::ExtendEdit{std::move(extension)}));
    steps.push_back(core::EngineCommand(core::EndEdit{ending}));
}

core::EngineResult lastResult(core::EditEngine& engine)
{
    engine.finish();
    std::vector<core::EngineResult> results = engine.collect();
    return results.empty() ? core::EngineResult{} : std::move(results.back());
}

} // namespace test
