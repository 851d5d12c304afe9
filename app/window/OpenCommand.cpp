// SPDX-License-Identifier: Apache-2.0
#include "app/window/OpenCommand.h"

#include "app/end/EndNote.h"
#include "app/end/OrderlyEnd.h"
#include "app/steps/Arguments.h"
#include "app/steps/TracedRun.h"
#include "app/window/Application.h"
#include "app/window/GuardedApplication.h"
#include "core/base/MemoryReserve.h"
#include "core/export/ScreenshotExport.h"
#include "core/repair/SeriesRepair.h"
#include "core/sessionfile/SessionFile.h"
#include "core/study/StudyLoader.h"
#include "ui/base/ErrorText.h"
#include "ui/dialogs/export/Screenshot.h"
#include "ui/frame/MessageBar.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/Workspace.h"

#include <QApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <QPixmap>
#include <QTimer>

#include <cstdio>
#include <optional>

namespace app {

namespace {

struct OpenArguments {
    QString path;
    QString series; ///< with the repair behind it
    QString study; ///< of a session that says another place
    QString screenshot;
    QSize size;
    bool demonstration = false;
};

std::optional<QSize> sizeFrom(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('x'));
    const QSize size(parts.value(0).toInt(), parts.value(1).toInt());
    if (parts.size() != 2 || size.width() < 320 || size.height() < 240)
        return std::nullopt;
    return size;
}

/// @return what is wrong, or nothing
QString parse(const Arguments& arguments, OpenArguments& parsed)
{
    if (arguments.rest().size() > 1)
        return QObject::tr("one path at a time: %1").arg(arguments.rest()[1]);
    parsed.path = arguments.rest().value(0);
    parsed.demonstration = arguments.has("demo");
    parsed.series = arguments.value("series");
    parsed.study = arguments.value("study");
    parsed.screenshot = arguments.value("screenshot");
    if (const core::Clause obstacle = ui::pictureNameObstacle(parsed.screenshot);
        !obstacle.isEmpty())
        return QObject::tr("--screenshot: %1").arg(obstacle);
    QString repair = arguments.value("repair");
    const QString spacing = arguments.value("spacing");
    if (arguments.has("size")) {
        const auto size = sizeFrom(arguments.value("size"));
        if (!size)
            return QObject::tr("--size %1: expected WIDTHxHEIGHT, at least 320x240")
                .arg(arguments.value("size"));
        parsed.size = *size;
    }
    if (parsed.demonstration && !parsed.path.isEmpty())
        return QObject::tr("--demo opens no path");
    const bool isSession = core::SessionFile::isNamedAt(parsed.path);
    if (isSession && !(parsed.series.isEmpty() && repair.isEmpty() && spacing.isEmpty()))
        return QObject::tr(
            "--series, --repair and --spacing are for studies; a session knows its own");
    if (parsed.path.isEmpty()
        && !(parsed.series.isEmpty() && repair.isEmpty() && spacing.isEmpty()))
        return QObject::tr("--series, --repair and --spacing are for a study; name its path");
    core::Clause wrong;
    if (!spacing.isEmpty() && !core::spacingWord(spacing, &wrong))
        return QObject::tr("--spacing: %1").arg(wrong);
    repair = repairWords(repair, spacing);
    if (!core::SeriesRepair::fromText(repair, &wrong))
        return QObject::tr("--repair: %1").arg(wrong);
    parsed.series = core::withRepair(parsed.series, repair);
    if (!isSession && !parsed.study.isEmpty())
        return QObject::tr("--study says where the study of a session is; name a session");
    return {};
}

int complain(const QString& sentence, int status)
{
    std::fprintf(stderr, "burin open: %s\n", qUtf8Printable(sentence));
    return status;
}

/// Saves the window once nothing is left to draw. Without anyone at the screen nothing is asked:
/// what would be a question or a message there ends the program here.
class Screenshot : public QObject {
public:
    Screenshot(Application& application, QString file)
        : m_window(application.window())
        , m_file(std::move(file))
    {
        ui::StudyOpener& opener = m_window.opener();
        // In place of the dialog.
        QObject::disconnect(&opener, &ui::StudyOpener::choiceNeeded, &m_window, nullptr);
        connect(&opener, &ui::StudyOpener::choiceNeeded, this, &Screenshot::refuseToGuess,
            Qt::QueuedConnection);
        QObject::disconnect(&opener, &ui::StudyOpener::spacingNeeded, &m_window, nullptr);
        connect(&opener, &ui::StudyOpener::spacingNeeded, this,
            [](const std::shared_ptr<const core::Study>& study, const QString& series) {
                // Which says how it is given on the command line.
                const auto loaded = study->load(series);
                QApplication::exit(loaded ? 1 : complain(ui::errorText(loaded.error()), 1));
            });
        QObject::disconnect(&opener, &ui::StudyOpener::sessionStudyNeeded, &m_window, nullptr);
        connect(&opener, &ui::StudyOpener::sessionStudyNeeded, this,
            [](const QString&, const QString&, const core::Error& why) {
                QApplication::exit(complain(ui::errorText(why), 1));
            });
        connect(&m_window.workspace(), &ui::Workspace::failed, this, [](const core::Error& error) {
            QApplication::exit(complain(ui::errorText(error), 1));
        });
        connect(&m_window.views(), &ui::ViewGrid::pictureChanged, this, &Screenshot::look);
    }

    /// For a window with nothing to wait for.
    void saveSoon() { QTimer::singleShot(200, this, &Screenshot::save); }

private:
    void refuseToGuess(const std::shared_ptr<const core::Study>& study)
    {
        const core::StudyListing& listing = study->listing();
        // A series in time is one volume, shown at its first point.
        if (const auto candidates = listing.candidates(); candidates.size() == 1) {
            m_window.opener().open(study, candidates.front()->key);
            return;
        }
        core::Error error{core::ErrorCode::SeriesAmbiguous, {listing.path}};
        for (const core::SeriesEntry* entry : listing.candidates())
            error.arguments += entry->line();
        if (error.arguments.size() == 1)
            error.code = core::ErrorCode::NoImages;
        QApplication::exit(complain(ui::errorText(error), 1));
    }

    void look()
    {
        if (m_saving || !m_window.workspace().volume() || !m_window.views().refined())
            return;
        m_saving = true;
        // Status line and panels take in what arrived with the last frame.
        QTimer::singleShot(300, this, &Screenshot::save);
    }

    void save()
    {
        if (m_window.workspace().volume() && !m_window.views().refined()) {
            m_saving = false;
            return;
        }
        const auto saved =
            ui::savePicture(m_window.grab().toImage(), m_window.workspace().volume(), m_file);
        QApplication::exit(saved ? 0 : complain(ui::errorText(saved.error()), 1));
    }

    ui::MainWindow& m_window;
    QString m_file;
    bool m_saving = false;
};

/// What is thrown in the middle of an event: the study is closed, whole on disk, and the window
/// says why. What the window shows of it would not be sure to be true.
/// @param application null: it is gone
void rescueBy(Application* application, bool goesOn)
{
    auto* guarded = dynamic_cast<GuardedApplication*>(qApp);
    if (!guarded)
        return;
    if (!application)
        return guarded->setRescue({});
    guarded->setRescue([application, goesOn](const core::Error& error) {
        if (!goesOn)
            return QApplication::exit(1);
        ui::MainWindow& window = application->window();
        window.opener().cancel();
        application->workspace().setSession(nullptr);
        core::keepMemoryReserve();
        window.messages().show(ui::MessageBar::Kind::Error,
            QObject::tr("The study was closed: %1. Every step that was done is in its session; "
                        "open it again to go on.")
                .arg(ui::errorText(error)));
    });
}

/// Closes the session of a program that was told to end, or whose display is gone: whoever started
/// it is told what is lost, as there is nobody to be asked.
void closeSession(ui::Workspace& workspace)
{
    if (const std::optional<core::Error> lost = workspace.dropSession())
        complain(QObject::tr("the last steps could not be written and are lost: %1")
                     .arg(ui::errorText(*lost)),
            1);
}

int runOpen(const Arguments& arguments)
{
    OpenArguments parsed;
    if (const QString wrong = parse(arguments, parsed); !wrong.isEmpty())
        return reportUsageError("open", wrong);
    if (!parsed.path.isEmpty() && !QFileInfo::exists(parsed.path)) {
        return complain(ui::errorText({core::ErrorCode::FileNotFound, {parsed.path}}), 1);
    }
    if (!parsed.screenshot.isEmpty()) {
        if (const auto fits = core::checkPictureTarget(parsed.screenshot); !fits)
            return complain(ui::errorText(fits.error()), 1);
    }
    auto application = Application::create();
    if (!application) {
        const QString why = ui::errorText(application.error());
        complain(why, 1);
        // Whoever clicked on an icon sees no stderr.
        if (parsed.screenshot.isEmpty())
            QMessageBox::critical(
                nullptr, QStringLiteral("Burin"), QObject::tr("Burin cannot start: %1.").arg(why));
        return 1;
    }
    ui::MainWindow& window = (*application)->window();
    window.resize(QSize(1600, 950));
    // A picture for others is not to depend on how this user left the window.
    if (parsed.screenshot.isEmpty())
        window.restoreLayout();
    if (parsed.size.isValid())
        window.resize(parsed.size);
    std::optional<Screenshot> screenshot;
    if (!parsed.screenshot.isEmpty())
        screenshot.emplace(**application, parsed.screenshot);
    rescueBy(application->get(), parsed.screenshot.isEmpty());
    window.show();
    std::optional<EndNote> note;
    if (parsed.screenshot.isEmpty()) {
        if (const QString earlier = EndNote::takeEarlier(); !earlier.isEmpty())
            window.messages().show(ui::MessageBar::Kind::Caution, earlier);
        note.emplace();
    }
    if (parsed.demonstration)
        (*application)->openDemonstration();
    else if (!parsed.study.isEmpty())
        window.opener().openSession(parsed.path, parsed.study);
    else if (!parsed.path.isEmpty())
        window.opener().open(parsed.path, parsed.series);
    else if (screenshot)
        screenshot->saveSoon();
    const OrderlyEnd end([&application] {
        (*application)->window().opener().abandon();
        closeSession((*application)->workspace());
    });
    const int status = QApplication::exec();
    // Whoever closes the window was asked.
    if (status != 0)
        closeSession((*application)->workspace());
    rescueBy(nullptr, false);
    return status;
}

} // namespace

const Command openCommand{.name = "open",
    .words = "[PATH]",
    .usage = "[PATH [--series UID] [--repair REPAIRS] [--spacing COLUMNS,ROWS,SLICES] | FILE.burin "
             "[--study PATH] | --demo]"
             " [--screenshot FILE.png] [--size WxH] [--trace FILE.json]",
    .summary = "opens the workstation's window with a study, or with a session that goes on; "
               "--screenshot saves a picture of it once it is fully refined, as PNG or, for .dcm, "
               "as Secondary Capture of the study, and exits",
    .options =
        std::vector<Option>{{"demo", nullptr, "opens the demonstration study"},
            {"study", "PATH", "where the study of a session is, if not where the session says"},
            {"screenshot", "FILE.png",
                "saves a picture of the window once it is fully refined, in place of a picture of "
                "that name, and exits; .dcm makes it a Secondary Capture of the study"},
            {"size", "WxH", "the size of the window in pixels"}}
        + seriesOptions() + spacingOption() + traceOption(),
    .needsWindow = true,
    .run = [](const Arguments& arguments) { return traced(arguments, runOpen); }};

} // namespace app
