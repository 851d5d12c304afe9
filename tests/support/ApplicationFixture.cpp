// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ApplicationFixture.h"

#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/SessionFiles.h"
#include "tests/support/SmallStudy.h"
#include "ui/MessageBar.h"

#include <QApplication>
#include <QDir>
#include <QPushButton>
#include <QSettings>
#include <QTest>

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

void look(const QPixmap& picture, const char* name)
{
    const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
    if (!folder.isEmpty())
        QVERIFY(picture.save(QDir(folder).filePath(QLatin1String(name))));
}

} // namespace test
