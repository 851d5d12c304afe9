// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"

#include <QMenu>
#include <QMenuBar>
#include <QTest>

namespace menuHeightsUiTest {

namespace {

/// A screen of a small laptop, without the menu bar.
constexpr int roomHeight = 720 - 30;

/// This menu and all below it that need more room than there is. Qt would draw them in two columns,
/// over the menu bar.
QStringList tooHigh(QMenu& menu, const QString& path, int& menus)
{
    ++menus;
    // Some are filled only when they open.
    Q_EMIT menu.aboutToShow();
    QStringList found;
    const int height = menu.sizeHint().height();
    if (height > roomHeight)
        found += QStringLiteral("%1: %2").arg(path).arg(height);
    for (const QAction* action : menu.actions()) {
        if (action->menu())
            found += tooHigh(
                *action->menu(), QStringLiteral("%1 > %2").arg(path, action->text()), menus);
    }
    return found;
}

} // namespace

class MenuHeightsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void menusFitLowScreens()
    {
        const test::ApplicationFixture fixture;
        QStringList found;
        int menus = 0;
        for (const QAction* action : fixture.window().findChild<QMenuBar*>()->actions()) {
            QVERIFY(action->menu());
            found += tooHigh(*action->menu(), action->text(), menus);
        }
        QVERIFY(menus > 15);
        QCOMPARE(found, QStringList());
    }
};

BURIN_WINDOW_TEST(MenuHeightsUiTest)

} // namespace menuHeightsUiTest

#include "MenuHeightsUiTest.moc"
