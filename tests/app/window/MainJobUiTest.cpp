// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"
#include "core/edits/EditJson.h"
#include "core/export/common/ExportFormats.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/SyntheticSeries.h"
#include "ui/dialogs/CodeDialog.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/input/Tool.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLineEdit>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

namespace mainJobUiTest {

namespace {

constexpr int patience = 300000; ///< ms; only a hang takes that long

QString text(const char* latin)
{
    return QLatin1String(latin);
}

/// A head of 48 × 48 × 40 voxels: bone 38 … 46 mm from the middle, brain and a ventricle within.
QString writeSmallHead(const QString& folder)
{
    test::SyntheticSeries series;
    series.size = {48, 48, 40};
    series.spacing = {2.0, 2.0};
    series.origin = {-47.0, -47.0, -48.75};
    series.step = {0.0, 0.0, 2.5};
    series.stored = [](const glm::ivec3& index) {
        const glm::dvec3 mm =
            (glm::dvec3(index) - glm::dvec3(23.5, 23.5, 19.5)) * glm::dvec3(2.0, 2.0, 2.5);
        const double distance = glm::length(mm);
        const int noise = (index.x * 7 + index.y * 13 + index.z * 29) % 11;
        const int hu = distance < 12.0 ? 8 : distance < 38.0 ? 38 : distance < 46.0 ? 900 : -990;
        return hu + noise + 1024;
    };
    test::writeSeries(series, folder);
    return folder;
}

/// Opens a study in the real window and does what a user does, by events alone.
class User {
public:
    User()
        : m_application(std::move(*app::Application::create()))
        , m_window(m_application->window())
    {
        m_window.resize(1280, 800);
        m_window.show();
        activate();
    }
    /// Keys are for the active window.
    void activate()
    {
        m_window.activateWindow();
        if (!QTest::qWaitForWindowActive(&m_window))
            qFatal("the window does not show");
    }

    [[nodiscard]] ui::MainWindow& window() { return m_window; }
    [[nodiscard]] ui::Workspace& workspace() { return m_application->workspace(); }
    [[nodiscard]] core::EditSession& session() { return *workspace().session(); }
    [[nodiscard]] ui::VolumeView& volumeView() { return m_window.views().volume(); }
    [[nodiscard]] core::RowId position() { return session().history().position(); }

    void open(const QString& folder)
    {
        m_window.opener().open(folder);
        wait([this] { return workspace().session() != nullptr; }, "the study does not open");
    }
    template <class Condition> static void wait(Condition condition, const char* complaint)
    {
        if (!QTest::qWaitFor(condition, patience))
            qFatal("%s", complaint);
    }
    void waitForRow(core::RowId row)
    {
        wait([this, row] { return position() == row; }, "the history does not get there");
    }
    void type(const char* field, double value)
    {
        auto* box = m_window.findChild<QDoubleSpinBox*>(text(field));
        if (!box)
            qFatal("no field %s", field);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QLocale().toString(value, 'f', 1));
        QTest::keyClick(box, Qt::Key_Return);
    }
    void click(const char* name)
    {
        auto* button = m_window.findChild<QAbstractButton*>(text(name));
        if (!button || !button->isEnabled())
            qFatal("%s cannot be clicked", name);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        activate();
        QTest::keyClick(&m_window, which, modifiers);
    }
    /// A pen stroke with rising pressure through points around the view's middle.
    void penStroke(QWidget& view, const std::vector<QPointF>& offsets)
    {
        test::Pen pen(view);
        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        quint64 time = 1000;
        pen.hover(middle + offsets.front(), time);
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            const double pressure = 0.55 + 0.45 * double(i) / double(offsets.size());
            time += 8;
            if (i == 0)
                pen.press(middle + offsets[i], pressure, time);
            else
                pen.move(middle + offsets[i], pressure, time);
            QCoreApplication::processEvents();
        }
        pen.release(middle + offsets.back(), time + 8);
    }
    void mouseStroke(QWidget& view, const QPoint& from, const QPoint& to)
    {
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, {}, middle + from);
        for (int step = 1; step <= 4; ++step)
            QTest::mouseMove(&view, middle + from + (to - from) * step / 4);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + to);
    }
    [[nodiscard]] QByteArray hash()
    {
        if (!session().settle())
            qFatal("the session does not settle");
        return session().stateHash();
    }
    /// For people who want to look: the folder is named by BURIN_SCREENSHOTS.
    void look(const char* name)
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            return;
        if (!test::waitUntilDrawn(m_window, workspace(), patience))
            qFatal("the views are not refined");
        // Panels count what a step changed 120 ms after it (GenerationSection), and tell nobody.
        QTest::qWait(200);
        m_window.grab().save(QDir(folder).filePath(text(name) + text(".png")));
    }

private:
    std::unique_ptr<app::Application> m_application;
    ui::MainWindow& m_window;
};

/// Answers the modal dialog that the next click opens.
void chooseSkullInTheDialogThatOpens()
{
    QTimer::singleShot(0, qApp, [] {
        auto* dialog = qobject_cast<ui::CodeDialog*>(QApplication::activeModalWidget());
        if (!dialog)
            qFatal("no dialog asks for the code");
        auto* search = dialog->findChild<QLineEdit*>(text("codeSearch"));
        QTest::keyClicks(search, text("skull"));
        QTest::keyClick(search, Qt::Key_Return);
    });
}

void exportTo(User& user, core::ExportFormat format, const QString& file)
{
    user.key(Qt::Key_E, Qt::ControlModifier);
    auto* dialog = user.window().findChild<ui::ExportDialog*>();
    if (!dialog)
        qFatal("no export dialog");
    auto* segments = dialog->findChild<QTreeWidget*>(text("exportSegments"));
    const core::Segment& segment = user.session().document().segments.front();
    if (!segment.code.isSet()) {
        auto* start = dialog->findChild<QAbstractButton*>(text("exportStart"));
        if (start->isEnabled())
            qFatal("a segment without a code must not be exported");
        const QRect cell = segments->visualRect(segments->model()->index(0, 2));
        chooseSkullInTheDialogThatOpens();
        QTest::mouseClick(segments->viewport(), Qt::LeftButton, {}, cell.center());
        User::wait([&user] { return user.session().document().segments.front().code.isSet(); },
            "the code is not taken");
    }
    auto* formats = dialog->findChild<QComboBox*>(text("exportFormat"));
    QTest::keyClick(formats, Qt::Key_Home);
    for (int step = 0; step < formats->count() && formats->currentData() != int(format); ++step)
        QTest::keyClick(formats, Qt::Key_Down);
    dialog->findChild<QLineEdit*>(text("exportFile"))->setText(file);
    QSignalSpy exported(dialog, &ui::ExportDialog::exported);
    QTest::mouseClick(dialog->findChild<QAbstractButton*>(text("exportStart")), Qt::LeftButton);
    User::wait([&exported] { return exported.count() == 1; }, "the export does not come");
    if (const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS"); !folder.isEmpty())
        dialog->grab().save(
            QDir(folder).filePath(QStringLiteral("export-%1.png").arg(int(format))));
    delete dialog;
}

struct Run {
    int status = -1;
    QList<QJsonObject> lines;
    QByteArray complaint;
};

Run burin(const QStringList& arguments)
{
    QProcess process;
    process.start(text(BURIN_PROGRAM), arguments);
    process.waitForFinished(patience);
    Run run;
    run.status = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    run.complaint = process.readAllStandardError();
    for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
        if (!line.isEmpty())
            run.lines.push_back(QJsonDocument::fromJson(line).object());
    }
    return run;
}

} // namespace

class MainJobUiTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("XDG_STATE_HOME", m_folder.filePath(text("state")).toUtf8());
        QSettings::setPath(
            QSettings::NativeFormat, QSettings::UserScope, m_folder.filePath(text("settings")));
    }

    void mainJob_data()
    {
        QTest::addColumn<QString>("study");
        QTest::newRow("small synthetic head")
            << writeSmallHead(m_folder.filePath(text("small head")));
        QTest::newRow("ct_cranium_inv3") << test::sharedCase(text("ct_cranium_inv3")).unpacked;
    }

    void mainJob()
    {
        QFETCH(QString, study);
        if (study.isEmpty())
            QSKIP("the shared test data are not here (BURIN_SHARED_DATA)");
        const QString base = m_folder.filePath(text(QTest::currentDataTag()).replace(u' ', u'_'));
        QStringList rows;
        QStringList hashes;
        QJsonArray edits;
        QByteArray finalHash;
        {
            User user;
            user.open(study);
            user.type("surfaceThreshold", 300.0);
            user.volumeView().lookFrom({-1.0, -0.25, 0.15});
            user.look("1-opened");
            const QByteArray untouched = user.hash();
            const core::WindowLevel grey = user.workspace().windowLevel();

            // Through the skull, with the pen, and a dab of the mouse beside it.
            user.key(Qt::Key_T);
            QVERIFY(user.workspace().activeTool());
            user.type("drillRadius", 11.0);
            user.type("drillDepth", 22.0);
            user.penStroke(
                user.volumeView(), {{-14, -30}, {-6, -28}, {2, -27}, {10, -29}, {16, -33}});
            user.waitForRow(1);
            user.mouseStroke(user.volumeView(), {10, -20}, {18, -12});
            user.waitForRow(2);
            user.look("2-drilled");
            QVERIFY(user.workspace().windowLevel() == grey);

            // Seeds on what is seen through the hole and beside it, and on a slice.
            user.key(Qt::Key_S);
            user.penStroke(user.volumeView(), {{-60, 10}, {-40, 4}, {-10, -28}, {8, -26}});
            user.waitForRow(4); // the segment and its seeds
            user.mouseStroke(user.window().views().axial(), {-70, -6}, {70, 8});
            user.waitForRow(5);
            auto* useSeeds = user.window().findChild<QAbstractButton*>(text("intervalFromSeeds"));
            User::wait([useSeeds] { return useSeeds->isEnabled(); }, "no interval is offered");
            user.look("3-seeded");

            // Grow: a step, a while at a pace until paused, the rest at once.
            user.type("rangeUpper", user.workspace().volume()->maximum);
            user.type("rangeLower", 226.0);
            user.click("growStep");
            user.waitForRow(6);
            auto* pace = user.window().findChild<QComboBox*>(text("growPace"));
            pace->setFocus();
            QTest::keyClick(pace, Qt::Key_Down);
            QVERIFY(user.workspace().growSettings().generationsPerSecond > 0.0);
            user.click("growPlay");
            User::wait(
                [&user] {
                    const auto progress = user.session().growthProgress();
                    return progress.open && progress.frontSizes.size() >= 3;
                },
                "the growth does not begin");
            user.click("growPlay");
            user.waitForRow(7);
            user.click("growToClosure");
            user.waitForRow(8);
            QVERIFY(user.session().document().segments.front().voxels > 1000);
            user.look("4-grown");

            const core::RowId last = user.position();
            const QByteArray grown = user.hash();
            for (core::RowId row = last; row > 0; --row) {
                user.key(Qt::Key_Z, Qt::ControlModifier);
                user.waitForRow(row - 1);
            }
            QCOMPARE(user.hash(), untouched);
            user.look("5-undone");
            for (core::RowId row = 1; row <= last; ++row) {
                user.key(Qt::Key_Y, Qt::ControlModifier);
                user.waitForRow(row);
            }
            QCOMPARE(user.hash(), grown);

            exportTo(user, core::ExportFormat::DicomSeg, base + text(".dcm"));
            QVERIFY(QFile::exists(base + text(".dcm")));
            exportTo(user, core::ExportFormat::Nifti, base + text(".nii.gz"));
            QVERIFY(QFile::exists(base + text(".nii.gz")));

            finalHash = user.hash();
            const core::History& history = user.session().history();
            for (const core::RowId id : history.pathTo(history.position())) {
                edits.append(core::editToJson(history.row(id).edit));
                hashes += QString::fromLatin1(history.row(id).stateHash);
                rows += history.row(id).name;
            }
        }

        // The same by recipe: hash for hash, and the same file to the byte.
        QFile recipe(base + text(".json"));
        QVERIFY(recipe.open(QIODevice::WriteOnly));
        const QJsonObject target{
            {text("format"), text("nifti")}, {text("file"), base + text("-recipe.nii.gz")}};
        recipe.write(
            QJsonDocument(QJsonObject{{text("edits"), edits}, {text("export"), QJsonArray{target}}})
                .toJson());
        recipe.close();
        const Run run = burin({text("run"), recipe.fileName(), text("--study"), study,
            text("--session"), base + text(".burin")});
        QVERIFY2(run.status == 0, run.complaint.constData());
        QCOMPARE(run.lines.size(), hashes.size() + 1);
        for (qsizetype i = 0; i < hashes.size(); ++i) {
            QVERIFY2(run.lines[i][text("hash")].toString() == hashes[i], qPrintable(rows[i]));
            QCOMPARE(run.lines[i][text("name")].toString(), rows[i]);
        }
        QCOMPARE(hashes.back().toLatin1(), finalHash);
        QVERIFY(!test::bytesOf(base + text(".nii.gz")).isEmpty());
        QCOMPARE(
            test::bytesOf(base + text("-recipe.nii.gz")), test::bytesOf(base + text(".nii.gz")));

        // The window's own session replays from scratch.
        const QDir sessions(m_folder.filePath(text("state/burin/sessions")));
        const QStringList files = sessions.entryList({text("*.burin")}, QDir::Files, QDir::Time);
        QVERIFY(!files.isEmpty());
        const Run replay =
            burin({text("replay"), sessions.filePath(files.front()), text("--verify")});
        QVERIFY2(replay.status == 0, replay.complaint.constData());
    }
};

BURIN_WINDOW_TEST(MainJobUiTest)

} // namespace mainJobUiTest

#include "MainJobUiTest.moc"
