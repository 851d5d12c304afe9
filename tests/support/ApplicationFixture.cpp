// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ApplicationFixture.h"

#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/SessionFiles.h"
#include "tests/support/SmallStudy.h"
#include "ui/MessageBar.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QDir>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

namespace test {

ApplicationFixture::ApplicationFixture()
{
    for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
        qputenv(name, path(name).toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path("settings"));
    writeSmallSeries(path("case/ct"), "2.25.1", 0, "Head, bone 1.0");
    start();
}

void ApplicationFixture::start()
{
    m_application.reset();
    m_application = *app::Application::create();
    window().resize(1280, 800);
    window().show();
    QVERIFY(QTest::qWaitForWindowExposed(&window()));
}

QString ApplicationFixture::bar() const
{
    return window().messages().sentence();
}

void ApplicationFixture::open(const QString& what) const
{
    window().opener().open(what);
    QTRY_VERIFY_WITH_TIMEOUT(workspace().session(), patience);
}

void ApplicationFixture::edit(const core::Edit& edit) const
{
    QVERIFY(session().apply(edit));
    QVERIFY(session().settle());
}

Dialogs::Dialogs(std::function<void(QWidget&)> answer)
{
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [answer = std::move(answer)] {
        if (QWidget* dialog = QApplication::activeModalWidget())
            answer(*dialog);
    });
    m_timer.start(50);
}

void press(QWidget& dialog, const QString& text)
{
    for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
        if (button->text().remove(u'&') == text)
            return button->click();
    }
    qFatal("no button %s", qPrintable(text));
}

std::size_t writeSession(const QString& file, const QString& study)
{
    reference::ReferenceEngine oracle;
    const auto made = *core::EditSession::create(oracle, *core::loadVolume(study), {.file = file});
    for (const core::Edit& each : manyEdits()) {
        static_cast<void>(made->apply(each));
        static_cast<void>(made->settle());
    }
    return made->history().rows().size();
}

bool waitUntilDrawn(ui::MainWindow& window, ui::Workspace& workspace, int patienceMs)
{
    // The pointer may have been moved, panels may have been shown: what comes of that goes first.
    QGuiApplication::sync();
    QCoreApplication::sendPostedEvents();
    if (!workspace.session()->settle())
        return false;
    // An edit is not part of a scene: a view takes its picture for new until the next one comes.
    // Another threshold and grey scale, by less than a picture can show, are another scene, and
    // what comes of that was asked for after the edit was done.
    const ui::ViewGrid& views = window.views();
    const ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
    const core::WindowLevel grey = workspace.windowLevel();
    constexpr double upwards = std::numeric_limits<double>::infinity();
    ui::Workspace::VolumeDisplay other = display;
    other.surfaceThreshold = std::nextafter(display.surfaceThreshold, upwards);
    workspace.setVolumeDisplay(other);
    workspace.setWindowLevel({std::nextafter(grey.centre, upwards), grey.width});
    const bool came = QTest::qWaitFor(
        [&views] {
            const auto all = views.views();
            return std::all_of(all.begin(), all.end(),
                [](const ui::ImageView* view) { return !view->isVisible() || view->quality(); });
        },
        patienceMs);
    workspace.setVolumeDisplay(display);
    workspace.setWindowLevel(grey);
    return came && QTest::qWaitFor([&views] { return views.refined(); }, patienceMs);
}

void look(const QPixmap& picture, const char* name)
{
    const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
    if (!folder.isEmpty())
        QVERIFY(picture.save(QDir(folder).filePath(QLatin1String(name))));
}

} // namespace test
