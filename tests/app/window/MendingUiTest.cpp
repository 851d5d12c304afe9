// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/frame/MendingStrip.h"
#include "ui/input/Tool.h"
#include "ui/report/AuditSaver.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

namespace mendingUiTest {

namespace {

using Step = ui::MendingStrip::Step;

/// The brain of the small study, without a lobe to the right.
core::Edit brainMask(double cutX)
{
    const core::VolumeGeometry geometry = test::smallStudy().volume.geometry;
    const glm::dvec3 middle = test::pointsInBrain().front();
    core::VoxelRuns runs;
    for (int z = 0; z < geometry.size.z; ++z) {
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x) {
                const glm::dvec3 place = geometry.toWorld({x, y, z});
                if (glm::length(place - middle) < 11.0 && place.x >= cutX)
                    runs.append(std::uint64_t((z * geometry.size.y + y) * geometry.size.x + x), 1);
            }
        }
    }
    return test::maskImport(
        QStringLiteral("brain.nrrd"), geometry.size, {{QStringLiteral("Brain"), runs, 0x4080C0}});
}

} // namespace

/// The strip that leads from an imported mask to its export.
class MendingUiTest : public QObject, private test::WithApplication {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeApplication();
        open(path("case/ct"));
    }
    void cleanup() { dropApplication(); }

    void fromTheMaskToTheExport()
    {
        const glm::dvec3 middle = test::pointsInBrain().front();
        const glm::dvec3 cut = middle - glm::dvec3(5.0, 0.0, 0.0);
        QVERIFY(!strip().isVisible());
        edit(brainMask(cut.x));
        QTRY_VERIFY(strip().isVisible());
        QVERIFY(strip().next() == Step::Look);

        // The first segment becomes active if none is.
        workspace().setActiveSegment(0);
        click("mendingLook");
        QCOMPARE(workspace().activeSegment(), 1);
        auto* list = window().findChild<QListWidget*>(QStringLiteral("placesToLookAt"));
        QTRY_VERIFY_WITH_TIMEOUT(list->count() > 0, patience);
        QTRY_VERIFY(list->isVisible());
        QTest::mouseClick(
            list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        QVERIFY(glm::distance(workspace().crosshairLps(), cut) < 4.0);
        QVERIFY(strip().next() == Step::Mend);

        click("mendingMend");
        QVERIFY(workspace().activeTool());
        QCOMPARE(workspace().activeTool()->iconName(), QStringLiteral("chunks"));
        QVERIFY(window().actionTable()[QStringLiteral("panel.ChunksPanel")].isChecked());
        click("mendingMend");
        QVERIFY(workspace().activeTool());
        workspace().setActiveTool(nullptr);
        edit(test::paintAt(1, {middle - glm::dvec3(7.0, 0.0, 0.0)}, 3.0));
        QTRY_VERIFY(strip().next() == Step::Compare);
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        test::look(window().grab(), "mending-strip.png");

        click("mendingCompare");
        QTRY_VERIFY_WITH_TIMEOUT(strip().next() == Step::Export, patience);
        auto* added = window().findChild<QLabel*>(QStringLiteral("compareAdded"));
        QTRY_VERIFY(added->isVisible());
        QVERIFY(added->text().endsWith(QStringLiteral(" mL")));
        QVERIFY(!added->text().startsWith(QLocale().toString(0.0, 'f', 2)));

        click("mendingExport");
        auto* dialog = window().findChild<ui::ExportDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        Q_EMIT dialog->exported(QStringLiteral("brain.dcm"));
        QVERIFY(!strip().next());
        static_cast<QDialog*>(dialog)->reject();
        // What is edited afterwards is not in the file.
        edit(test::eraseAt(1, {middle}, 2.0));
        QTRY_VERIFY(strip().next() == Step::Export);
        // Without the import there is nothing to be mended.
        QVERIFY(session().goTo(0));
        QVERIFY(session().settle());
        QTRY_VERIFY(!strip().isVisible());
    }

    /// The report shows what was added and what was taken since the import.
    void theReportShowsWhatWasMended()
    {
        const glm::dvec3 middle = test::pointsInBrain().front();
        edit(brainMask(middle.x - 5.0));
        edit(test::paintAt(1, {middle - glm::dvec3(7.0, 0.0, 0.0)}, 3.0));
        edit(test::eraseAt(1, {middle + glm::dvec3(2.0, 0.0, 0.0)}, 2.0));
        auto* saver = window().findChild<ui::AuditSaver*>();
        QSignalSpy saved(saver, &ui::AuditSaver::saved);
        saver->save(path("audit.html"));
        QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, patience);
        QFile file(path("audit.html"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        QVERIFY(text.contains(QStringLiteral("As they stand after step 3.")));
        static const QRegularExpression change(QStringLiteral(
            "imported; ([0-9.]+) mL added and ([0-9.]+) mL taken since, Dice 0\\.9"));
        const QRegularExpressionMatch match = change.match(text);
        QVERIFY(match.hasMatch());
        QVERIFY(match.captured(1).toDouble() > 0.0);
        QVERIFY(match.captured(2).toDouble() > 0.0);

        static const QRegularExpression image(
            QStringLiteral("alt=\"Brain, slice \\d+\" src=\"data:image/png;base64,([^\"]+)\""));
        const QImage picture =
            QImage::fromData(QByteArray::fromBase64(image.match(text).captured(1).toLatin1()));
        QVERIFY(!picture.isNull());
        int green = 0;
        int red = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                green += colour.green() > colour.red() + 60 ? 1 : 0;
                red += colour.red() > colour.green() + 60 ? 1 : 0;
            }
        }
        QVERIFY(green > 50);
        QVERIFY(red > 50);
    }

    /// A step that was left out does not lead back.
    void whoBeginsWithMending()
    {
        const glm::dvec3 middle = test::pointsInBrain().front();
        edit(brainMask(middle.x - 5.0));
        QVERIFY(strip().next() == Step::Look);
        click("mendingMend");
        QVERIFY(strip().next() == Step::Mend);
        workspace().setActiveTool(nullptr);
        edit(test::paintAt(1, {middle - glm::dvec3(7.0, 0.0, 0.0)}, 3.0));
        QTRY_VERIFY(strip().next() == Step::Compare);
        click("mendingCompare");
        QTRY_VERIFY_WITH_TIMEOUT(strip().next() == Step::Export, patience);
        click("mendingExport");
        auto* dialog = window().findChild<ui::ExportDialog*>();
        QVERIFY(dialog);
        Q_EMIT dialog->exported(QStringLiteral("brain.dcm"));
        static_cast<QDialog*>(dialog)->reject();
        QVERIFY(strip().next() == Step::Look);
    }

    /// Ticked places need no mending.
    void placesThatAreRight()
    {
        edit(brainMask(test::pointsInBrain().front().x - 5.0));
        workspace().setActiveSegment(1);
        click("mendingLook");
        auto* list = window().findChild<QListWidget*>(QStringLiteral("placesToLookAt"));
        QTRY_VERIFY_WITH_TIMEOUT(list->count() > 0, patience);
        QVERIFY(strip().next() == Step::Mend);
        for (int row = 0; row < list->count(); ++row)
            list->item(row)->setCheckState(Qt::Checked);
        QVERIFY(strip().next() == Step::Compare);
    }

    void itIsClosedAndComesBack()
    {
        QAction& action = window().actionTable()[QStringLiteral("mending.strip")];
        QVERIFY(action.isChecked());
        edit(brainMask(-100.0));
        QTRY_VERIFY(strip().isVisible());
        // In a small window it fits, and takes little of it.
        window().resize(1280, 720);
        QCoreApplication::processEvents();
        QCOMPARE(window().size(), QSize(1280, 720));
        QVERIFY(strip().height() <= 28);
        for (const auto* button : strip().findChildren<QToolButton*>()) {
            QVERIFY(strip().rect().contains(button->geometry()));
            QVERIFY(button->width() >= button->sizeHint().width());
        }
        // Under the pen nothing moves.
        QVERIFY(session().begin(test::paintAt(1, {test::pointsInBone().front()}, 2.0)));
        QVERIFY(session().transactionOpen());
        action.trigger();
        QVERIFY(strip().isVisible());
        session().end(core::Ending::Commit);
        QVERIFY(session().settle());
        QTRY_VERIFY(!strip().isVisible());
        action.trigger();
        QVERIFY(strip().isVisible());

        click("mendingClose");
        QVERIFY(!strip().isVisible());
        QVERIFY(!action.isChecked());
        // It stays closed, also in a window that is opened later.
        const QString file = session().file();
        m_fixture->start();
        window().opener().openSession(file);
        QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
        QTRY_COMPARE(session().history().rows().size(), std::size_t(2));
        QVERIFY(!strip().isVisible());
        // A session with an imported mask shows it at once.
        QAction& again = window().actionTable()[QStringLiteral("mending.strip")];
        QVERIFY(!again.isChecked());
        again.trigger();
        QVERIFY(strip().isVisible());
        window().closeStudy();
        QTRY_VERIFY(!workspace().session());
        QVERIFY(!strip().isVisible());
        window().opener().openSession(file);
        QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
        QTRY_VERIFY(strip().isVisible());
    }

    /// Carving changes voxels, too, but no segment.
    void carvingIsNoMending()
    {
        const glm::dvec3 middle = test::pointsInBrain().front();
        edit(brainMask(middle.x - 5.0));
        workspace().setActiveSegment(1);
        click("mendingLook");
        auto* list = window().findChild<QListWidget*>(QStringLiteral("placesToLookAt"));
        QTRY_VERIFY_WITH_TIMEOUT(list->count() > 0, patience);
        QVERIFY(strip().next() == Step::Mend);
        edit(test::carveAt({middle}, 3.0));
        QCoreApplication::processEvents();
        QCOMPARE(session().history().position(), core::RowId(2));
        QVERIFY(session().history().row(2).statistics.voxelsChanged > 0);
        QVERIFY(strip().next() == Step::Mend);
        edit(core::SegmentToLayer{.segment = 1, .layer = 1});
        QCoreApplication::processEvents();
        QVERIFY(session().history().row(3).statistics.voxelsChanged > 0);
        QVERIFY(strip().next() == Step::Mend);
        edit(test::paintAt(1, {middle - glm::dvec3(7.0, 0.0, 0.0)}, 3.0));
        QTRY_VERIFY(strip().next() == Step::Compare);
    }

    /// A growth can stand open for long.
    void itIsClosedWhileAStepStandsOpen()
    {
        edit(brainMask(-100.0));
        QTRY_VERIFY(strip().isVisible());
        QVERIFY(session().begin(test::paintAt(1, {test::pointsInBone().front()}, 2.0)));
        QVERIFY(session().transactionOpen());
        click("mendingClose");
        QVERIFY(!strip().isVisible());
        session().end(core::Ending::Commit);
        QVERIFY(session().settle());
        QCoreApplication::processEvents();
        QVERIFY(!strip().isVisible());
        window().actionTable()[QStringLiteral("mending.strip")].trigger();
        QVERIFY(strip().isVisible());
    }

private:
    [[nodiscard]] ui::MendingStrip& strip() { return window().mendingStrip(); }
    void click(const char* name)
    {
        auto* button = strip().findChild<QToolButton*>(QLatin1String(name));
        QVERIFY(button && button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
    }
};

BURIN_WINDOW_TEST(MendingUiTest)

} // namespace mendingUiTest

#include "MendingUiTest.moc"
