// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/growth/SeedWord.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/cases/growth/CutPromises.h"
#include "tests/support/cases/growth/RealGrowths.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>

namespace realCutGlTest {

using test::RealStructure;

/// Strokes over what has grown in real studies: what CutGrowth promises holds (CutPromises.h), and
/// what is foreseen is what goes.
class RealCutGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_fixture->newErrors(), 0); }

    void strokes_data();
    void strokes();

private:
    /// Its seeds and its growth, as a user makes them; cuts are left out.
    core::Document grow(const test::RealGrowth& real);
    core::EngineResult apply(const core::EngineEdit& edit);
    /// Takes a cut, looks at its promises, and takes it back. @return voxels that went; or
    /// none, where it was refused
    std::optional<std::int64_t> take(const test::Words& before, const core::CutGrowth& cut);

    std::unique_ptr<test::EditEngineFixture> m_fixture;
    std::uint32_t m_generation = 0;
    QString m_broken;
};

void RealCutGlTest::initTestCase()
{
    m_fixture = std::make_unique<test::EditEngineFixture>();
    QVERIFY2(m_fixture->isReady(), m_fixture->why());
}

void RealCutGlTest::strokes_data()
{
    QTest::addColumn<int>("structure");
    QTest::newRow("liver") << int(RealStructure::Liver);
    QTest::newRow("aorta") << int(RealStructure::Aorta);
    QTest::newRow("ventricles") << int(RealStructure::Ventricles);
}

core::Document RealCutGlTest::grow(const test::RealGrowth& real)
{
    core::EditEngine& engine = m_fixture->engine();
    engine.finish();
    (void)engine.collect();
    if (!engine.openVolume(real.study.volume.geometry.size, real.study.codes))
        qFatal("the study is not opened");
    core::Document document = core::initialDocument(real.study.volume);
    for (const core::Edit& edit : real.edits) {
        if (edit.is<core::AddSegment>())
            (void)core::applyToDocument(edit, document);
        else if (edit.is<core::SeedStroke>())
            apply(*core::engineEditOf(edit, document));
        else if (edit.is<core::GrowSteps>()) {
            core::submitWhole(engine, *core::engineEditOf(edit, document), {core::GrowAdvance{}});
            m_generation = test::lastResult(engine).generation;
        }
    }
    return document;
}

core::EngineResult RealCutGlTest::apply(const core::EngineEdit& edit)
{
    core::submitWhole(m_fixture->engine(), edit);
    return test::lastResult(m_fixture->engine());
}

std::optional<std::int64_t> RealCutGlTest::take(
    const test::Words& before, const core::CutGrowth& cut)
{
    core::EditEngine& engine = m_fixture->engine();
    engine.submit(core::PreviewCut{cut});
    const core::EngineResult asked = test::lastResult(engine);
    if (asked.error)
        return std::nullopt;
    const core::EngineResult done = apply(cut);
    m_broken = test::brokenPromise(before, test::seedWordsOf(engine, before.size), cut);
    if (!asked.cutPreview || asked.cutPreview->voxels != done.statistics.voxelsChanged)
        m_broken = QStringLiteral("another number of voxels was foreseen");
    core::SwapBricks back;
    for (const core::BrickChange& change : done.changes)
        back.bricks.push_back({change.key, change.before});
    engine.submit(back);
    (void)test::lastResult(engine);
    if (test::seedWordsOf(engine, before.size).values != before.values)
        m_broken = QStringLiteral("undo brings back something else");
    return done.statistics.voxelsChanged;
}

void RealCutGlTest::strokes()
{
    QFETCH(int, structure);
    const std::optional<test::RealGrowth> real = test::realGrowth(RealStructure(structure));
    if (!real)
        QSKIP("the shared data are not there");
    (void)grow(*real);
    const test::Words before =
        test::seedWordsOf(m_fixture->engine(), real->study.volume.geometry.size);
    const auto grown =
        std::count_if(before.values.begin(), before.values.end(), core::seedWord::isMember);
    QVERIFY(grown > 1000);
    test::Random random(12);
    using How = core::CutGrowth::How;
    for (int number = 0; number < 8; ++number) {
        core::CutGrowth cut{.generation = m_generation};
        cut.voxels = test::strokeOverMembers(before, test::randomInt(random, 23, 40), random);
        for (const How how : {How::Subtree, How::Here, How::Neck}) {
            cut.how = how;
            const std::optional<std::int64_t> gone = take(before, cut);
            const test::Sketched sketched = test::sketchedMembers(before, cut);
            QCOMPARE(gone.has_value(), sketched.roots == 0);
            QVERIFY2(m_broken.isEmpty(), qPrintable(m_broken));
            qInfo("%s, stroke %d of %d voxels, how %d: %s of %lld go", QTest::currentDataTag(),
                number, sketched.members, int(how),
                gone ? QByteArray::number(qlonglong(*gone)).constData() : "refused, none",
                static_cast<long long>(grown));
        }
    }
}

BURIN_TEST(RealCutGlTest)

} // namespace realCutGlTest

#include "RealCutGlTest.moc"
