// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/PutBricks.h"

#include "core/engine/EngineCommands.h"
#include "core/growth/SeedWord.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <functional>
#include <map>

using namespace core;

namespace test {

namespace {

constexpr std::size_t voxels = BrickGrid::voxelsPerBrick;
constexpr BrickKey labelKey{Field::Labels, 0, 0};
constexpr BrickKey coverageKey{Field::Coverage, 1, 0};

/// Voxels of one value where @p holds says so, 0 elsewhere.
std::vector<std::uint8_t> filled(std::uint8_t value, const std::function<bool(std::size_t)>& holds)
{
    std::vector<std::uint8_t> bytes(voxels, 0);
    for (std::size_t i = 0; i < voxels; ++i)
        bytes[i] = holds(i) ? value : std::uint8_t(0);
    return bytes;
}

bool inFirstHalf(std::size_t voxel)
{
    return voxel < voxels / 2;
}
bool inSecondHalf(std::size_t voxel)
{
    return voxel >= voxels / 2;
}
bool inWhole(std::size_t)
{
    return true;
}

/// An engine that is asked one thing at a time.
class Talk {
public:
    explicit Talk(EditEngine& engine)
        : m_engine(engine)
    {
        const glm::ivec3 size(32, 16, 16);
        m_engine.finish();
        (void)m_engine.collect();
        if (!m_engine.openVolume(size, constantVolume(size, tissueCode).values))
            wrong = QStringLiteral("the volume cannot be opened");
    }

    EngineResult ask(EngineCommand command)
    {
        const Ticket ticket = m_engine.submit(std::move(command));
        m_engine.finish();
        for (EngineResult& result : m_engine.collect()) {
            if (result.ticket == ticket)
                return std::move(result);
        }
        wrong = QStringLiteral("no answer came");
        return {};
    }
    /// What is answered only where it fails.
    void begin(EngineEdit edit)
    {
        m_engine.submit(BeginEdit{std::move(edit)});
        m_engine.finish();
        expect(m_engine.collect().empty(), "an edit cannot begin");
    }
    EngineResult put(std::vector<BrickImage> bricks, const LabelGuard& guard = {})
    {
        return ask(SwapBricks{.bricks = std::move(bricks), .guard = guard});
    }
    EngineResult lay(std::vector<BrickImage> differences, const LabelGuard& guard = {})
    {
        return ask(XorBricks{.differences = std::move(differences), .guard = guard});
    }
    void expect(bool holds, const char* what)
    {
        if (!holds && wrong.isEmpty())
            wrong = QLatin1String(what);
    }
    void expectHeld(const BrickKey& key, const std::vector<std::uint8_t>& bytes)
    {
        const EngineResult read = ask(ReadBricks{.keys = {key}});
        expect(read.changes.size() == 1 && read.changes[0].after.read() == bytes,
            "the brick does not hold what it should");
    }
    void expectRefused(const EngineResult& result, ErrorCode code, int label)
    {
        expect(result.error && result.error->code == code
                && result.error->arguments.value(0).toInt() == label,
            "it is not refused for that label");
        expect(result.changes.empty(), "what is refused has changes");
    }

    QString wrong;

private:
    EditEngine& m_engine;
};

void layingTwiceIsNothing(Talk& talk)
{
    const auto first = filled(3, inFirstHalf);
    const auto all = filled(7, inWhole);
    talk.put({{labelKey, first}});
    const EngineResult laid = talk.lay({{labelKey, all}});
    talk.expect(laid.changes.size() == 1 && laid.facts.voxelsChanged == std::int64_t(voxels),
        "every voxel differs");
    talk.expect(laid.facts.flow(0, 3).lost == std::int64_t(voxels / 2), "3 is gone");
    talk.expect(laid.facts.flow(0, 4).gained == std::int64_t(voxels / 2), "3 xor 7 has come");
    talk.expect(talk.lay({{labelKey, all}, {labelKey, all}}).changes.empty(),
        "a difference that is laid over twice at once changes nothing");
    talk.lay({{labelKey, all}});
    talk.expectHeld(labelKey, first);
    talk.lay({{labelKey, first}});
    talk.expectHeld(labelKey, {});
}

void keptLabelsNeitherComeNorGo(Talk& talk)
{
    const auto held = filled(3, inFirstHalf);
    const auto other = filled(5, inSecondHalf);
    talk.put({{labelKey, held}});
    LabelGuard guard;
    guard.kept.set(3);
    talk.expectRefused(talk.put({{labelKey, {}}}, guard), ErrorCode::SegmentLocked, 3);
    talk.expectRefused(talk.lay({{labelKey, held}}, guard), ErrorCode::SegmentLocked, 3);
    talk.expectRefused(
        talk.put({{{Field::Labels, 0, 1}, held}}, guard), ErrorCode::SegmentLocked, 3);
    talk.expectHeld(labelKey, held);
    talk.expect(!talk.lay({{labelKey, other}}, guard).error, "5 may come beside 3");
    guard.kept.set(5);
    talk.expectRefused(talk.lay({{labelKey, other}}, guard), ErrorCode::SegmentLocked, 5);
}

void protectedLabelsAreNotCarved(Talk& talk)
{
    talk.put({{labelKey, filled(3, inFirstHalf)}, {coverageKey, filled(100, inFirstHalf)}});
    LabelGuard guard;
    guard.uncarved.labels.set(3);
    talk.expectRefused(
        talk.put({{coverageKey, filled(101, inWhole)}}, guard), ErrorCode::SegmentProtected, 3);
    talk.expectRefused(
        talk.lay({{coverageKey, filled(2, inFirstHalf)}}, guard), ErrorCode::SegmentProtected, 3);
    talk.expectHeld(coverageKey, filled(100, inFirstHalf));
    // Less is no carving, nor is it where the label is not.
    const EngineResult less = talk.lay({{coverageKey, filled(100, inFirstHalf)}}, guard);
    talk.expect(!less.error && less.changes.size() == 1, "what was carved may be filled");
    talk.expect(!talk.put({{coverageKey, filled(255, inSecondHalf)}}, guard).error,
        "what is not protected may be carved");
    talk.expect(!talk.put({{coverageKey, {}}}, guard).error, "all may be filled");
    // In a further plane, which must be named, and beside one of the first.
    talk.put({{{Field::Labels, 2, 0}, filled(7, inSecondHalf)}});
    guard.uncarved.labels.set(7);
    talk.expect(!talk.put({{coverageKey, filled(9, inSecondHalf)}}, guard).error,
        "a plane that is not named protects nothing");
    guard.uncarved.planes.set(2);
    talk.expectRefused(
        talk.put({{coverageKey, filled(10, inSecondHalf)}}, guard), ErrorCode::SegmentProtected, 7);
    talk.expectRefused(
        talk.put({{coverageKey, filled(10, inFirstHalf)}}, guard), ErrorCode::SegmentProtected, 3);
    talk.expectHeld(coverageKey, filled(9, inSecondHalf));
}

void whatIsNotWholeIsRefused(Talk& talk)
{
    const auto refuses = [&talk](const EngineResult& result) {
        talk.expect(result.error && result.error->code == ErrorCode::InvalidField,
            "it is not refused as unsound");
    };
    refuses(talk.lay({{labelKey, {}}})); // a difference has its bytes
    refuses(talk.lay({{labelKey, std::vector<std::uint8_t>(17, 1)}}));
    refuses(talk.put({{labelKey, std::vector<std::uint8_t>(17, 1)}}));
    refuses(talk.lay({{{Field::Labels, 0, 2}, filled(1, inWhole)}}));
    refuses(talk.ask(ReadSeedWords{.voxels = {{32, 0, 0}}}));
    refuses(talk.ask(ReadSeedWords{.voxels = {{0, -1, 0}}}));
    talk.begin(SeedPlacement{.label = 1});
    refuses(talk.lay({{labelKey, filled(1, inWhole)}}));
    talk.ask(EndEdit{.ending = Ending::Rollback});
}

void seedWordsOfVoxels(Talk& talk)
{
    const std::vector<glm::ivec3> seeds{{1, 2, 3}, {31, 15, 15}};
    talk.begin(SeedPlacement{.label = 4, .voxels = seeds});
    talk.ask(EndEdit{});
    const EngineResult read =
        talk.ask(ReadSeedWords{.voxels = {seeds[1], {0, 0, 0}, seeds[0], seeds[1]}});
    const std::uint32_t seed = seedWord::pendingSeed(4);
    talk.expect(read.seedWords == std::vector<std::uint32_t>{seed, seedWord::unvisited, seed, seed},
        "the words are not those of the voxels");
    talk.expect(talk.ask(ReadSeedWords{.voxels = seeds, .plane = 3}).seedWords
            == std::vector<std::uint32_t>(2, seedWord::unvisited),
        "another plane has seeds");
}

/// Also of a plane that nobody looks at, and while an edit is open.
void barriersWhereTheyAre(Talk& talk)
{
    const BrickKey first{Field::SeedWords, 0, 0};
    const BrickKey second{Field::SeedWords, 0, 1};
    const BrickKey elsewhere{Field::SeedWords, 3, 1};
    const auto expect = [&talk](std::uint8_t plane, const std::vector<BrickImage>& held) {
        const EngineResult read = talk.ask(ReadBarriers{.plane = plane});
        bool same = !read.error && read.changes.size() == held.size();
        for (std::size_t i = 0; same && i < held.size(); ++i)
            same = read.changes[i].key == held[i].key && read.changes[i].before.empty()
                && read.changes[i].after == held[i].bytes;
        talk.expect(same, "other bricks hold barriers");
    };
    const auto wordsAt = [](std::uint32_t word, std::size_t place) {
        std::vector<std::uint8_t> bytes(4 * voxels, emptyByte(Field::SeedWords));
        for (std::size_t byte = 0; byte < 4; ++byte)
            bytes[4 * place + byte] = std::uint8_t(word >> (8 * byte));
        return bytes;
    };
    const std::vector<std::uint8_t> barrier = wordsAt(seedWord::barrier, voxels - 1);
    const std::vector<std::uint8_t> seed = wordsAt(seedWord::pendingSeed(4), 0);
    expect(0, {});
    talk.put({{first, seed}, {second, barrier}, {elsewhere, barrier}});
    expect(0, {{second, barrier}});
    expect(3, {{elsewhere, barrier}});
    expect(2, {});
    talk.put({{first, barrier}, {second, {}}});
    expect(0, {{first, barrier}});
    talk.begin(SeedPlacement{.label = 4, .voxels = {{20, 0, 0}}});
    expect(0, {{first, barrier}});
    talk.ask(EndEdit{.ending = Ending::Rollback});
}

const std::map<QString, void (*)(Talk&)>& rows()
{
    static const std::map<QString, void (*)(Talk&)> known{
        {QStringLiteral("laying twice is nothing"), layingTwiceIsNothing},
        {QStringLiteral("kept labels neither come nor go"), keptLabelsNeitherComeNorGo},
        {QStringLiteral("protected labels are not carved"), protectedLabelsAreNotCarved},
        {QStringLiteral("barriers where they are"), barriersWhereTheyAre},
        {QStringLiteral("what is not whole is refused"), whatIsNotWholeIsRefused},
        {QStringLiteral("seed words of voxels"), seedWordsOfVoxels}};
    return known;
}

} // namespace

void addPutBricksRows()
{
    QTest::addColumn<QString>("name");
    for (const auto& [name, row] : rows())
        QTest::newRow(qPrintable(name)) << name;
}

QString tryPutBricks(EditEngine& engine, const QString& name)
{
    Talk talk(engine);
    if (talk.wrong.isEmpty())
        rows().at(name)(talk);
    return talk.wrong;
}

} // namespace test
