// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/panels/CleanUpWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <functional>
#include <vector>

namespace cleanUpPreviewUiTest {

using test::pointAt;
using test::pointAway;

namespace {

struct Fixture : test::CleanUpWindow {
    Fixture()
        : CleanUpWindow(Answers::ByThemselves)
    {
    }
    /// Two dabs of one segment, a segment without voxels, and one around the first dab that lies in
    /// another label plane.
    [[nodiscard]] bool addDabs()
    {
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        const glm::dvec3 first = geometry.toWorld({10.0, 10.0, 10.0});
        apply(test::addSegment("Parts"));
        apply(test::addSegment("Other"));
        apply(core::AddSegment{.name = QStringLiteral("Over"), .plane = 1});
        apply(test::paintAt(1, {first}, 2.0));
        one = voxels(1);
        apply(test::paintAt(1, {geometry.toWorld({28.0, 24.0, 10.0})}, 3.0));
        apply(test::paintAt(3, {first}, 4.0));
        workspace.setActiveSegment(1);
        previewBox().setChecked(true);
        return one > 0 && voxels(3) > one && QTest::qWaitFor([this] { return panel->isVisible(); });
    }
    template <class E> [[nodiscard]] bool previews()
    {
        return session().isOpen<E>() && session().openIsPreview() && session().openHasBegun();
    }
    /// By how many voxels the segment becomes larger that is inverted.
    [[nodiscard]] std::int64_t inverted()
    {
        const glm::ivec3 size = workspace.volume()->geometry.size;
        return std::int64_t(size.x) * size.y * size.z - voxels(2) - 2 * voxels(1);
    }
    /// Opens the menu of "Combine". @return an entry of it
    [[nodiscard]] QAction& entry(const char* submenu, const QString& other)
    {
        if (!combinations().isVisible())
            QTest::mouseClick(
                panel->findChild<QPushButton*>(QStringLiteral("cleanUp.combine")), Qt::LeftButton);
        auto* menu = combinations().findChild<QMenu*>(QLatin1String(submenu));
        const QList<QAction*> entries = menu ? menu->actions() : QList<QAction*>();
        const auto found = std::find_if(entries.begin(), entries.end(),
            [&other](const QAction* each) { return each->text() == other; });
        if (found == entries.end())
            qFatal("no entry in %s", submenu);
        return **found;
    }
    [[nodiscard]] QMenu& combinations()
    {
        return *panel->findChild<QMenu*>(QStringLiteral("cleanUp.combinations"));
    }

    std::int64_t one = 0; ///< voxels of the first dab
};

} // namespace

/// Inverting, splitting by the plane and combining are seen before they are done.
class CleanUpPreviewUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("cleanUp"));
    }

    void anInversion()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const QString expected = fixture.more(fixture.inverted());
        const std::int64_t after = fixture.voxels(1) + fixture.inverted();
        const QByteArray hash = fixture.session().stateHash();
        const std::size_t rows = fixture.rows();
        QPushButton& button = fixture.button("invert");
        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        QVERIFY(fixture.previews<core::InvertSegment>());
        pointAway(button);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), hash);
        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        QTest::mouseClick(&button, Qt::LeftButton);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(1), after);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);
    }

    /// Esc and Ctrl+Z take back what is seen, and not the step before it.
    void keysTakeBackThePreviewAlone()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const QString expected = fixture.more(fixture.inverted());
        const QByteArray hash = fixture.session().stateHash();
        const core::RowId position = fixture.session().history().position();
        QPushButton& button = fixture.button("invert");
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        const auto escape = [&] { QTest::keyClick(&button, Qt::Key_Escape); };
        const auto undo = [&] { QTest::keyClick(&button, Qt::Key_Z, Qt::ControlModifier); };
        for (const auto& press : std::vector<std::function<void()>>{escape, undo}) {
            pointAt(button);
            QTRY_COMPARE(fixture.now(), expected);
            press();
            QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
            QCOMPARE(fixture.session().history().position(), position);
            QCOMPARE(fixture.session().stateHash(), hash);
            // Nor does it come back while the pointer stays.
            QTest::qWait(500);
            QVERIFY(!fixture.session().openEdit());
            pointAway(button);
        }
    }

    /// Nor does a field have them, which leaves undo to the window.
    void keysTakeItBackInTheFieldOfAButton()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const core::RowId position = fixture.session().history().position();
        auto& size = *fixture.panel->findChild<QDoubleSpinBox*>(QStringLiteral("cleanUp.smallMm3"));
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        size.setFocus(Qt::MouseFocusReason);
        QTRY_VERIFY(fixture.previews<core::CleanSegment>());
        QTest::keyClick(&size, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), position);
    }

    /// What waits for a growth to end leaves the keys to that.
    void keysAreThoseOfWhatStandsOpen()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const glm::dvec3 place = fixture.workspace.volume()->geometry.toWorld({20.0, 20.0, 10.0});
        QVERIFY(fixture.session().begin(test::paintAt(1, {place}, 2.0)));
        QVERIFY(fixture.session().transactionOpen() && !fixture.session().openIsPreview());
        pointAt(fixture.button("invert"));
        QTest::qWait(500);
        QVERIFY(!fixture.session().isOpen<core::InvertSegment>());
        QShortcut escape(QKeySequence(Qt::Key_Escape), &fixture.window);
        QSignalSpy escaped(&escape, &QShortcut::activated);
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        QTest::keyClick(&fixture.window.views().axial(), Qt::Key_Escape);
        QCOMPARE(escaped.size(), 1);
        fixture.session().end(core::Ending::Rollback);
        QVERIFY(fixture.session().settle());
    }

    /// The new segment is seen in its colour, and is there once it is a step.
    void aSplitByThePlane()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        QPushButton& button = fixture.button("splitByPlane");
        pointAt(button); // without a plane there is nothing to see
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        pointAway(button);
        ui::CuttingPlane& plane = fixture.workspace.plane();
        const auto place = [&](double column) {
            plane.setPose(ui::CuttingPlane::poseFacing(
                geometry.toWorld({column, 18.0, 10.0}), {1.0, 0.0, 0.0}));
        };
        place(20.0);
        plane.show();
        const std::int64_t before = fixture.voxels(1);
        const QString expected = fixture.more(fixture.one - before);
        const std::size_t rows = fixture.rows();
        const auto isVisible = [&] {
            return bool(fixture.workspace.segmentDisplay().visible[std::size_t(4)]);
        };
        QVERIFY(!isVisible());
        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        QVERIFY(fixture.previews<core::SplitSegment>() && isVisible());
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(3));
        place(1.0);
        QTRY_COMPARE(
            fixture.now(), QStringLiteral("%1\nstays as it is").arg(fixture.sizeOf(before)));
        place(20.0);
        QTRY_COMPARE(fixture.now(), expected);
        pointAway(button);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QVERIFY(!isVisible());
        QCOMPARE(fixture.rows(), rows);
        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        QTest::mouseClick(&button, Qt::LeftButton);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(1), fixture.one);
        QCOMPARE(fixture.voxels(4), before - fixture.one);
        QCOMPARE(fixture.session().document().segment(4)->name, QStringLiteral("Parts 1"));
    }

    void combinations_data()
    {
        QTest::addColumn<QByteArray>("submenu");
        QTest::newRow("union") << QByteArray("uniteSegments");
        QTest::newRow("subtract") << QByteArray("subtractSegment");
        QTest::newRow("intersect") << QByteArray("intersectSegments");
    }
    /// An entry is seen while it is pointed at; choosing it takes what is seen.
    void combinations()
    {
        QFETCH(const QByteArray, submenu);
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const std::int64_t before = fixture.voxels(1);
        const std::int64_t change = submenu == "uniteSegments" ? fixture.voxels(3) - fixture.one
            : submenu == "subtractSegment"                     ? -fixture.one
                                                               : fixture.one - before;
        const QString expected = fixture.more(change);
        const QByteArray hash = fixture.session().stateHash();
        const std::size_t rows = fixture.rows();
        const QString over = QStringLiteral("Over");
        fixture.entry(submenu.constData(), over).hover();
        QTRY_COMPARE(fixture.now(), expected);
        QVERIFY(fixture.previews<core::CombineSegments>());
        // One that cannot be chosen would do nothing.
        fixture.entry(submenu.constData(), QStringLiteral("Other")).hover();
        QVERIFY(!fixture.session().openEdit());
        fixture.entry(submenu.constData(), over).hover();
        QTRY_COMPARE(fixture.now(), expected);
        fixture.combinations().close();
        QTRY_VERIFY(!fixture.session().openEdit());
        QTRY_COMPARE(fixture.now(), fixture.sizeOf(before));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), hash);

        QAction& entry = fixture.entry(submenu.constData(), over);
        entry.hover();
        QTRY_COMPARE(fixture.now(), expected);
        fixture.combinations().close(); // before it is told, as in a menu that is clicked
        entry.trigger();
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(1), before + change);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);
    }

    /// Keys that lead out of a menu take back what an entry of it would do; the study takes the
    /// whole menu along, whose segments are not those of the next one.
    void theMenuLeavesNothing()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const QString expected = fixture.more(fixture.voxels(1), 2);
        const std::size_t rows = fixture.rows();
        const QString other = QStringLiteral("Other");
        fixture.entry("mergeSegments", other).hover();
        QTRY_COMPARE(fixture.now(), expected);
        QTest::keyClick(&fixture.combinations(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QVERIFY(fixture.combinations().isVisible());
        QCOMPARE(fixture.rows(), rows);
        fixture.entry("mergeSegments", other).hover();
        QTRY_COMPARE(fixture.now(), expected);
        fixture.workspace.setSession(nullptr);
        QVERIFY(!fixture.combinations().isVisible());
    }

    /// It is told how large the segment becomes that receives the voxels.
    void aMerge()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const QString expected = fixture.more(fixture.voxels(1), 2);
        fixture.entry("mergeSegments", QStringLiteral("Other")).hover();
        QTRY_COMPARE(fixture.now(), expected);
        fixture.combinations().close();
        QTRY_VERIFY(!fixture.session().openEdit());
        QTRY_COMPARE(fixture.now(), fixture.sizeOf(fixture.voxels(1)));
    }
};

BURIN_WINDOW_TEST(CleanUpPreviewUiTest)

} // namespace cleanUpPreviewUiTest

#include "CleanUpPreviewUiTest.moc"
