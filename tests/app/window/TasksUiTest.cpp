// SPDX-License-Identifier: Apache-2.0
#include "core/demo/HeadPhantom.h"
#include "core/nifti/NiftiWriter.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/cases/growth/RealGrowths.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/MadeScans.h"
#include "ui/frame/MendingStrip.h"
#include "ui/frame/PanelSection.h"
#include "ui/input/Tool.h"
#include "ui/models/StatisticsModel.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/panels/lists/StatisticsPanel.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/ShownValues.h"
#include "ui/workspace/Workspace.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QRegularExpression>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace tasksUiTest {

namespace {

QString text(const char* latin)
{
    return QLatin1String(latin);
}

/// How many steps a task takes, as the page has it.
int stepsOnPage(const char* task)
{
    QFile file(QStringLiteral(BURIN_SOURCE_DIR "/resources/help/tasks.md"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no page of tasks");
    for (const QString& section : QString::fromUtf8(file.readAll()).split(text("\n## "))) {
        static const QRegularExpression together(
            QStringLiteral("\\n\\| together \\| \\d+ \\| (\\d+) \\|"));
        const QRegularExpressionMatch match = together.match(section);
        if (section.startsWith(text(task) + u'\n') && match.hasMatch())
            return match.captured(1).toInt();
    }
    return -1;
}

/// Works in the real window with mouse and keys alone, and counts: each click, drag, stroke, key
/// and choice from a list is a step. Changing the slice and waiting are none.
class User : public test::ApplicationFixture {
public:
    using Way = std::vector<glm::dvec3>; ///< LPS mm

    [[nodiscard]] int steps() const { return m_steps; }
    [[nodiscard]] std::size_t rows() const { return session().history().rows().size(); }
    [[nodiscard]] const core::Document& document() const { return session().document(); }
    [[nodiscard]] ui::SliceView& axial() const { return window().views().axial(); }

    template <class Condition> static void wait(const Condition& condition, const char* complaint)
    {
        if (!QTest::qWaitFor(condition, patience))
            qFatal("%s", complaint);
    }
    void openScan(const test::MadeScan& scan) const
    {
        scan.write(path("scan"));
        open(path("scan"));
        if (workspace().volume()->geometry.size != scan.size())
            qFatal("the scan has become another one");
    }
    void showSlice(const glm::dvec3& throughLps) const
    {
        workspace().setCrosshairLps(throughLps);
        QCoreApplication::processEvents();
    }
    [[nodiscard]] std::vector<std::uint8_t> mask(int label) const
    {
        if (!session().settle())
            qFatal("the session does not settle");
        const auto labels = session().questions().labels(0);
        if (!labels)
            qFatal("no labels");
        return test::maskOf(*labels, std::uint8_t(label));
    }

    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        ++m_steps;
        window().activateWindow();
        if (!QTest::qWaitForWindowActive(&window()))
            qFatal("the window is not active");
        QTest::keyClick(&window(), which, modifiers);
    }
    /// Takes a tool by its key.
    void take(Qt::Key which, const char* icon, Qt::KeyboardModifiers modifiers = {})
    {
        key(which, modifiers);
        if (!isInHand(icon))
            qFatal("%s is not in hand", icon);
    }
    [[nodiscard]] bool isInHand(const char* icon) const
    {
        const ui::Tool* tool = workspace().activeTool();
        return tool && tool->iconName() == text(icon);
    }
    void click(const char* button) { press(shown<QAbstractButton>(button)); }
    /// Clicks on the button in the header of a panel that does something.
    void clickInHeader(const char* action)
    {
        for (QToolButton* each : window().findChildren<QToolButton*>()) {
            const QAction* its = each->defaultAction();
            if (its && its->objectName() == text(action) && each->isVisible())
                return press(*each);
        }
        qFatal("%s is in no header", action);
    }
    /// Clicks on the header of a panel, beside its title.
    void clickHeader(const char* panel)
    {
        ++m_steps;
        auto& section = shown<ui::PanelSection>(panel);
        for (QFrame* each : section.findChildren<QFrame*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (each->property("role") == text("bar"))
                return QTest::mouseClick(each, Qt::LeftButton);
        }
        qFatal("%s has no header", panel);
    }
    void clickAt(ui::ImageView& view, const glm::dvec3& placeLps)
    {
        ++m_steps;
        const QPointF pixel = view.context().toPixel(placeLps);
        test::WindowFixture::hover(view, pixel);
        test::WindowFixture::click(view, pixel);
    }
    /// @param beforeLift what happens while the button is still down
    void draw(ui::ImageView& view, const std::vector<QPointF>& way,
        const std::function<void()>& beforeLift = {})
    {
        ++m_steps;
        constexpr int parts = 4;
        test::WindowFixture::hover(view, way.front());
        test::WindowFixture::mouse(view, QEvent::MouseButtonPress, way.front());
        for (std::size_t i = 1; i < way.size(); ++i) {
            for (int part = 1; part <= parts; ++part)
                test::WindowFixture::mouse(view, QEvent::MouseMove,
                    way[i - 1] + (way[i] - way[i - 1]) * (double(part) / parts));
        }
        if (beforeLift)
            beforeLift();
        test::WindowFixture::mouse(view, QEvent::MouseButtonRelease, way.back());
    }
    /// Sketches seeds on the axial slice, and waits until the panel knows which values they have.
    void sketch(const Way& way)
    {
        const std::size_t before = rows();
        std::vector<QPointF> pixels;
        for (const glm::dvec3& placeLps : way)
            pixels.push_back(axial().context().toPixel(placeLps));
        draw(axial(), pixels);
        const auto* advice = window().findChild<QLabel*>(text("growAdvice"));
        wait([&] { return rows() > before && advice->text().contains(u'·'); },
            "the sketch gives no interval");
    }
    /// Grows until nothing is left, or until growth stops by itself at a leak.
    void grow()
    {
        const std::size_t before = rows();
        key(Qt::Key_G, Qt::ControlModifier);
        waitForGrowth(before);
    }
    /// Whether growth has stopped and asks for a leak.
    [[nodiscard]] bool isAsked() const
    {
        return window().findChild<QAbstractButton*>(text("leakAccept"))->isVisible();
    }
    /// Says that it is none; growth goes on as far as in grow().
    void accept()
    {
        const std::size_t before = rows();
        click("leakAccept");
        waitForGrowth(before);
    }
    void drop(const QString& file)
    {
        ++m_steps;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(
            QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window(), &enter);
        QDropEvent event(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window(), &event);
    }
    void openMenu(const char* title)
    {
        ++m_steps;
        auto* bar = window().findChild<QMenuBar*>();
        for (QAction* each : bar->actions()) {
            if (!each->menu() || each->text().remove(u'&') != text(title))
                continue;
            m_menu = each->menu();
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(each).center());
            wait([this] { return m_menu->isVisible(); }, "the menu does not open");
            return;
        }
        qFatal("no menu %s", title);
    }
    void chooseEntry(const char* entry)
    {
        ++m_steps;
        for (QAction* each : m_menu->actions()) {
            if (each->text().remove(u'&') == text(entry) && each->isEnabled())
                return QTest::mouseClick(
                    m_menu, Qt::LeftButton, {}, m_menu->actionGeometry(each).center());
        }
        qFatal("no entry %s", entry);
    }
    /// Chooses the last entry of a list.
    void chooseLast(const char* list, const char* entry)
    {
        ++m_steps;
        auto& box = shown<QComboBox>(list);
        box.setFocus();
        QTest::keyClick(&box, Qt::Key_End);
        if (box.currentText() != text(entry))
            qFatal("%s is not chosen", entry);
    }

private:
    void waitForGrowth(std::size_t rowsBefore) const
    {
        const auto* panel = window().findChild<ui::GrowthPanel*>();
        wait([&] { return !panel->running() && rows() > rowsBefore; }, "the growth does not end");
    }
    template <class Widget> [[nodiscard]] Widget& shown(const char* name) const
    {
        auto* widget = window().findChild<Widget*>(text(name));
        if (!widget || !widget->isVisible() || !widget->isEnabled())
            qFatal("%s cannot be used", name);
        return *widget;
    }
    void press(QAbstractButton& button)
    {
        ++m_steps;
        // The mark of a check box, which may be wider than its words.
        QTest::mouseClick(&button, Qt::LeftButton, {}, QPoint(10, button.height() / 2));
    }

    int m_steps = 0;
    QMenu* m_menu = nullptr;
};

QByteArray told(double number)
{
    return QByteArray::number(number, 'f', 4);
}

} // namespace

/// The tasks of the page "Four tasks, step by step", done as they stand there: each takes as many
/// steps as the page says, and comes to what it should.
class TasksUiTest : public QObject {
    Q_OBJECT

private:
    static constexpr int patience = test::ApplicationFixture::patience;

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void ventriclesAndSkull()
    {
        const test::MadeScan head = test::coarseHead();
        User user;
        user.openScan(head);
        constexpr double sliceMm = 24.75;
        user.showSlice({0.0, 0.0, sliceMm});
        user.take(Qt::Key_S, "seed");
        // From the outer table of the bone to its inner one, and back, so that both are meant, and
        // what lies between them.
        user.sketch({{60.0, -26.7, sliceMm}, {59.1, -17.0, sliceMm}, {65.5, -9.2, sliceMm},
            {63.5, 0.0, sliceMm}, {66.8, 9.4, sliceMm}, {63.5, 18.2, sliceMm},
            {65.5, 29.2, sliceMm}});
        QVERIFY(user.workspace().growSettings().guard.on);
        user.grow();
        constexpr int steps = 10; // for a complaint in place of a test that does not end
        while (user.isAsked() && user.steps() < steps)
            user.accept();
        QVERIFY(!user.isAsked());
        user.clickInHeader("addSegment");
        QTRY_COMPARE_WITH_TIMEOUT(user.document().segments.size(), std::size_t(2), patience);
        QCOMPARE(user.workspace().activeSegment(), 2);
        for (const double side : {1.0, -1.0})
            user.sketch({{side * 8.5, -16.0, sliceMm}, {side * 8.5, -8.0, sliceMm},
                {side * 12.0, 10.0, sliceMm}, {side * 15.0, 18.0, sliceMm},
                {side * 19.0, 27.0, sliceMm}, {side * 20.5, 32.0, sliceMm}});
        user.grow();
        QCOMPARE(user.steps(), stepsOnPage("Ventricles and skull of a CT"));

        const double skull = test::dice(user.mask(1), head.mask([](int part, const glm::dvec3&) {
            return part >= int(core::HeadPart::Skull) && part <= int(core::HeadPart::Teeth);
        }));
        // What was sketched are the lateral ones. Voxels at their border are no fluid alone.
        const double ventricles =
            test::dice(user.mask(2), head.mask([](int part, const glm::dvec3& placeLps) {
                return part == int(core::HeadPart::Ventricles) && std::abs(placeLps.x) > 4.0;
            }));
        qInfo("skull: Dice %.3f; lateral ventricles: %.3f", skull, ventricles);
        QVERIFY2(skull > 0.9, told(skull).constData());
        QVERIFY2(ventricles > 0.8, told(ventricles).constData());
    }

    void aLiverWithALeakAndALobeMissing()
    {
        const test::MadeScan scan = test::mistakenLiver();
        const auto truth =
            scan.mask([](int part, const glm::dvec3&) { return (part & test::isLiver) != 0; });
        User user;
        user.openScan(scan);
        user.showSlice(scan.placeLps(test::inLiver));
        constexpr std::uint8_t liverOfNetwork = 5;
        std::vector<std::uint8_t> labels = scan.mask(
            [](int part, const glm::dvec3&) { return (part & test::isTakenForLiver) != 0; });
        for (std::uint8_t& label : labels)
            label *= liverOfNetwork;
        const QString file = user.path("segmentations.nii.gz");
        QVERIFY(core::writeNifti(
            file, {.geometry = user.workspace().volume()->geometry, .voxels = labels}));

        user.drop(file);
        QTRY_COMPARE_WITH_TIMEOUT(user.document().segments.size(), std::size_t(1), patience);
        QTRY_VERIFY_WITH_TIMEOUT(user.window().mendingStrip().isVisible(), patience);
        const int label = user.document().segments.front().label;
        QTRY_COMPARE_WITH_TIMEOUT(user.workspace().activeSegment(), label, patience);
        const double before = test::dice(user.mask(label), truth);
        user.click("mendingMend");
        QVERIFY(user.isInHand("chunks"));
        user.click("divide");
        const ui::Chunks& chunks = user.workspace().chunks();
        QTRY_VERIFY_WITH_TIMEOUT(
            chunks.map() && !chunks.isWorking() && !chunks.isCounting(), patience);
        for (const glm::dvec3& place : {test::inLeak, test::inLobe}) {
            const std::size_t rows = user.rows();
            user.clickAt(user.axial(), scan.placeLps(place));
            QTRY_COMPARE_WITH_TIMEOUT(user.rows(), rows + 1, patience);
            QTRY_VERIFY_WITH_TIMEOUT(!chunks.isCounting(), patience);
        }
        QCOMPARE(user.steps(), stepsOnPage("A network's liver with a leak and a lobe missing"));

        const double after = test::dice(user.mask(label), truth);
        qInfo("liver: Dice %.3f, then %.3f", before, after);
        QVERIFY2(before < 0.9, told(before).constData());
        QVERIFY2(after > 0.99, told(after).constData());
    }

    void aLungLesion()
    {
        const test::MadeScan scan = test::lungWithLesion();
        User user;
        user.openScan(scan);
        user.showSlice({0.0, 0.0, 0.5});
        user.take(Qt::Key_S, "seed");
        user.sketch({{-9.0, -0.5, 0.5}, {9.0, 0.5, 0.5}});
        user.grow();
        const auto* section = user.window().findChild<ui::PanelSection*>(text("StatisticsPanel"));
        QVERIFY(section && section->isFolded());
        user.clickHeader("StatisticsPanel");
        QVERIFY(!section->isFolded());
        QCOMPARE(user.steps(), stepsOnPage("A lung lesion, segmented and measured"));

        const auto* panel = user.window().findChild<ui::StatisticsPanel*>();
        QTRY_VERIFY_WITH_TIMEOUT(panel->statistics().of(1) && !panel->statistics().isLooking()
                && !panel->statistics().isBehind(1),
            patience);
        const auto* table = panel->findChild<QTableView*>(text("segmentStatistics"));
        QVERIFY(table->isVisible());
        const auto number = [table](const char* key) {
            const int column = ui::StatisticsModel::columnOf(text(key));
            const QVariant cell =
                table->model()->index(0, column).data(ui::StatisticsModel::NumberRole);
            return table->isColumnHidden(column) ? 0.0 : cell.toDouble();
        };
        const auto truth = scan.mask([](int part, const glm::dvec3&) { return part == 1; });
        const double truthMl = double(std::count(truth.begin(), truth.end(), 1)) / 1000.0;
        const double measuredMl = number("volumeMl");
        QVERIFY2(std::abs(measuredMl / truthMl - 1.0) < 0.02, told(measuredMl).constData());
        const double longestMm = number("longestDiameterMm");
        QVERIFY2(std::abs(longestMm - test::lesionMm) < 1.5, told(longestMm).constData());
        const double found = test::dice(user.mask(1), truth);
        QVERIFY2(found > 0.98, told(found).constData());
    }

    /// The head of the fixture: what is seen in 3D is the ball of its bone, with all within.
    void aVolumeInTwoByADrawnCut()
    {
        User user;
        user.open(user.path("case/ct"));
        user.openMenu("Sculpt");
        user.chooseEntry("New segment of what I see in 3D");
        QTRY_COMPARE_WITH_TIMEOUT(user.document().segments.size(), std::size_t(1), patience);
        QVERIFY(user.session().settle());
        const core::LoadedVolume study = test::smallStudy();
        const ui::ShownValues shown = ui::shownValues(user.workspace().volumeDisplay());
        const std::int64_t seen =
            std::count_if(study.codes.begin(), study.codes.end(), [&](std::uint16_t code) {
                const double value = study.volume.encoding.value(code);
                return value >= shown.lower.value_or(value) && value <= shown.upper.value_or(value);
            });
        QVERIFY(seen > 0);
        QCOMPARE(user.document().segment(1)->voxels, seen);

        user.take(Qt::Key_K, "segment-scissors", Qt::ShiftModifier);
        user.chooseLast("segmentScissorsDoes", "split along a line");
        ui::VolumeView& view = user.window().views().volume();
        // From edge to edge, a little beside the middle.
        const QPointF middle = view.context().toPixel(test::pointsInBrain().front());
        const QPointF beside(2.0 / view.context().mmPerPixel(), 0.0);
        const QPointF up(0.0, 0.4 * view.height());
        const auto* tool = user.window().findChild<ui::SegmentScissorsTool*>();
        user.draw(view, {middle + beside - up, middle + beside + up}, [tool] {
            User::wait([tool] { return tool->partsLine().count(text("mL")) == 2; },
                "the volumes do not stand at the pointer");
        });
        QTRY_COMPARE_WITH_TIMEOUT(user.document().segments.size(), std::size_t(2), patience);
        QCOMPARE(user.steps(), stepsOnPage("A volume split in two by a drawn cut"));

        QVERIFY(user.session().settle());
        const std::int64_t first = user.document().segment(1)->voxels;
        const std::int64_t second = user.document().segment(2)->voxels;
        QCOMPARE(first + second, seen);
        QVERIFY2(second > seen / 4 && second < first,
            qPrintable(QStringLiteral("%1 %2").arg(first).arg(second)));
    }

    /// The page has a number for each, and for nothing else.
    void thePageIsRead()
    {
        QVERIFY(stepsOnPage("A volume split in two by a drawn cut") > 0);
        QCOMPARE(stepsOnPage("A task that nobody has"), -1);
    }
};

BURIN_WINDOW_TEST(TasksUiTest)

} // namespace tasksUiTest

#include "TasksUiTest.moc"
