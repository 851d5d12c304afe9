// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ManualWindow.h"

#include "tests/support/ApplicationFixture.h"
#include "ui/PanelSection.h"
#include "ui/panels/Panel.h"

#include <QDir>
#include <QSettings>
#include <QtTest>

#include <algorithm>

namespace test {

namespace {

constexpr int patience = 300000; ///< ms; only a hang takes that long

} // namespace

void ManualWindow::wantPictures()
{
    if (!qEnvironmentVariableIsSet("BURIN_SCREENSHOTS"))
        QSKIP("BURIN_SCREENSHOTS names no folder for pictures");
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
        m_folder.filePath(QStringLiteral("settings")));
    QCoreApplication::setApplicationName(QStringLiteral("burin"));
    QCoreApplication::setOrganizationName(QStringLiteral("burin"));
}

void ManualWindow::start()
{
    m_application.reset();
    // No picture goes on with the session of the one before.
    QDir(m_folder.filePath(QStringLiteral("state"))).removeRecursively();
    m_application = std::move(*app::Application::create());
    window().resize(1280, 800);
    window().show();
}

bool ManualWindow::wait(const std::function<bool()>& condition)
{
    return QTest::qWaitFor(condition, patience);
}

bool ManualWindow::waitUntilDrawn()
{
    return test::waitUntilDrawn(window(), workspace(), patience);
}

void ManualWindow::apply(const core::Edit& edit)
{
    QVERIFY(session().apply(edit));
    QVERIFY(waitUntilDrawn());
}

void ManualWindow::foldAllBut(const std::vector<QString>& titles)
{
    for (ui::PanelSection* section : window().findChildren<ui::PanelSection*>())
        section->setFolded(
            std::find(titles.begin(), titles.end(), section->panel().title()) == titles.end());
}

void ManualWindow::save(const QPixmap& picture, const char* name)
{
    QVERIFY(picture.save(
        QDir(qEnvironmentVariable("BURIN_SCREENSHOTS")).filePath(QLatin1String(name))));
}

void ManualWindow::openLesion()
{
    start();
    m_application->openDemonstration();
    QVERIFY(wait([this] { return workspace().session() != nullptr; }));
    QVERIFY(waitUntilDrawn());
    foldAllBut({QStringLiteral("Segments"), QStringLiteral("Surface")});
    apply(core::AddSegment{.name = QStringLiteral("Tumour"), .rgb = 0xE07A5F});
    workspace().setActiveSegment(1);
    core::PaintStroke lesion{.segment = 1};
    lesion.path = {.radiusMm = 20.0, .pointsLps = {{24, -18, 40}, {10, 4, 46}}};
    apply(lesion);
    lesion.path = {.radiusMm = 7.0, .pointsLps = {{36, -30, 42}, {50, -44, 44}}};
    apply(lesion);
    apply(core::LaySurface{.segment = 1, .vertices = 9000});
    apply(core::MarkSurface{
        .mark = core::SurfaceMark::Green, .path = {.radiusMm = 26.0, .pointsLps = {{6, 14, 50}}}});
}

} // namespace test
