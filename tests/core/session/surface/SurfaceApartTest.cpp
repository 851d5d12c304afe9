// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <vector>

namespace surfaceApartTest {

using namespace core;

/// What changes a mask under its surface, whether it is about that segment or not, is told: now,
/// after undo and redo, and when the session is opened again.
class SurfaceApartTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void parts_data();
    void parts();
    void partsNot_data();
    void partsNot();

private:
    /// Segment 1 is brain that grew a few steps, segment 2 a ball of bone; the surface is around 1.
    void begin(const QString& file = {})
    {
        auto made = EditSession::create(m_engine, test::smallStudy(), {.file = file});
        QVERIFY(made);
        m_session = *std::move(made);
        for (const Edit& edit : {Edit(test::addSegment("Brain")), Edit(test::addSegment("Bone")),
                 Edit(test::seedInBrain(1)), Edit(test::growBrain(5)),
                 Edit(LaySurface{.segment = 1, .vertices = 300})})
            run(edit);
        QVERIFY(!isApart());
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = m_session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(m_session->settle());
    }
    [[nodiscard]] bool isApart() const { return m_session->document().surface->isApart(); }

    reference::ReferenceEngine m_engine;
    std::unique_ptr<EditSession> m_session;
};

namespace {

} // namespace

void SurfaceApartTest::parts_data()
{
    QTest::addColumn<Edit>("edit");
    QTest::newRow("growth that goes on") << Edit(test::growBrain(3));
    QTest::newRow("growth taken back") << Edit(ShrinkSteps{.steps = 2});
    QTest::newRow("another segment painted over it")
        << test::paintOverAt(2, test::pointsInBrain(), 2.5);
    QTest::newRow("erased") << test::eraseAt(1, test::pointsInBrain(), 2.5);
}

void SurfaceApartTest::parts()
{
    QFETCH(Edit, edit);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("s.burin"));
    begin(file);
    run(edit);
    QVERIFY(isApart());
    QVERIFY(m_session->undo());
    QVERIFY(m_session->settle());
    QVERIFY(!isApart());
    QVERIFY(m_session->redo());
    QVERIFY(m_session->settle());
    QVERIFY(isApart());

    m_session.reset();
    auto opened = EditSession::open(m_engine, test::smallStudy(), file);
    QVERIFY(opened);
    m_session = *std::move(opened);
    QVERIFY(m_session->settle());
    QVERIFY(isApart());
    // Whoever writes back takes the mask as it is now.
    run(WriteBack{});
    QVERIFY(!isApart());
}

void SurfaceApartTest::partsNot_data()
{
    QTest::addColumn<std::vector<Edit>>("edits");
    QTest::newRow("growth of another segment")
        << std::vector<Edit>{Edit(test::seedInBone(2)), Edit(test::growBone(3))};
    QTest::newRow("marks") << std::vector<Edit>{Edit(ChangeMarks{.way = ChangeMarks::Way::Invert})};
    QTest::newRow("growth to where nothing is left to take")
        << std::vector<Edit>{Edit(test::growBetween(3000, 3001, 1))};
    QTest::newRow("drill") << std::vector<Edit>{Edit(test::drillAt(0.0))};
}

void SurfaceApartTest::partsNot()
{
    QFETCH(std::vector<Edit>, edits);
    begin();
    for (const Edit& edit : edits)
        run(edit);
    QVERIFY(!isApart());
}

BURIN_TEST(SurfaceApartTest)

} // namespace surfaceApartTest

#include "SurfaceApartTest.moc"
