// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/OwnSettings.h"
#include "tests/support/program/TestProgram.h"
#include "ui/frame/WindowPlace.h"

#include <QDataStream>
#include <QScreen>
#include <QSettings>
#include <QTest>

namespace windowPlaceUiTest {

namespace {

QRect screenRect()
{
    return QGuiApplication::primaryScreen()->availableGeometry();
}

/// What QWidget::saveGeometry() writes of a window on a screen of that width.
QByteArray keptOn(int screenPixels, const QRect& window, int screen = 0)
{
    QByteArray kept;
    QDataStream stream(&kept, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_4_0);
    constexpr quint32 magic = 0x1D9D0CB;
    stream << magic << quint16(3) << quint16(0) << window << window << qint32(screen) << quint8(0)
           << quint8(0) << qint32(screenPixels) << window;
    return kept;
}

} // namespace

/// The window comes back where it was closed, and whole on a screen that has become smaller.
class WindowPlaceUiTest : public QObject {
    Q_OBJECT

    test::OwnSettings m_settings;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_settings.clear();
    }

    void itLiesWithin_data()
    {
        QTest::addColumn<QRect>("window");
        QTest::addColumn<QRect>("placed");
        QTest::addRow("inside") << QRect(100, 90, 800, 500) << QRect(100, 90, 800, 500);
        QTest::addRow("over the right edge")
            << QRect(900, 90, 800, 500) << QRect(480, 90, 800, 500);
        QTest::addRow("over the lower edge")
            << QRect(100, 400, 800, 500) << QRect(100, 220, 800, 500);
        QTest::addRow("left of it") << QRect(-2000, 90, 800, 500) << QRect(0, 90, 800, 500);
        QTest::addRow("its title above it")
            << QRect(100, -50, 800, 500) << QRect(100, ui::titleBarPixels, 800, 500);
        QTest::addRow("larger") << QRect(100, 90, 1900, 1000)
                                << QRect(0, ui::titleBarPixels, 1280, 720 - ui::titleBarPixels);
    }
    void itLiesWithin()
    {
        QFETCH(const QRect, window);
        QFETCH(const QRect, placed);
        QCOMPARE(ui::placeWithin(window, QRect(0, 0, 1280, 720)), placed);
        // On a screen beside the first one, too.
        const QPoint beside(1920, 200);
        QCOMPARE(ui::placeWithin(window.translated(beside), QRect(beside, QSize(1280, 720))),
            placed.translated(beside));
    }

    void itComesBackWhereItWas()
    {
        // No place or size that a window has by itself, on a screen of any size.
        const QRect place = screenRect().adjusted(61, 57, -53, -41);
        {
            test::WindowFixture fixture(test::headFirstSupine());
            fixture.window.restoreLayout(); // nothing is kept yet
            fixture.window.setGeometry(place);
            QGuiApplication::sync();
            QTRY_COMPARE(fixture.window.geometry(), place);
            fixture.window.close();
        }
        QVERIFY(!QSettings().value(QStringLiteral("window/geometry")).toByteArray().isEmpty());
        test::WindowFixture fixture(test::headFirstSupine());
        QVERIFY(fixture.window.geometry() != place);
        fixture.window.restoreLayout();
        QTRY_COMPARE(fixture.window.geometry(), place);
    }

    /// Screens that Qt takes a place of (up to a quarter wider), and one that it does not; and one
    /// beside this one, which is gone.
    void aSmallerScreenHoldsIt_data()
    {
        QTest::addColumn<int>("screenPixels");
        QTest::addColumn<QRect>("window");
        QTest::addColumn<int>("screen");
        const QRect here = screenRect();
        const int wider = here.width() * 6 / 5;
        QTest::addRow("larger than this one")
            << wider << QRect(150, 120, here.width() + 200, here.height() + 150) << 0;
        QTest::addRow("over its edges")
            << wider << QRect(here.width() - 700, here.height() - 400, 1300, 800) << 0;
        QTest::addRow("twice as wide")
            << 2 * here.width() << QRect(150, 120, 2 * here.width() - 300, here.height() + 150)
            << 0;
        QTest::addRow("on one that is gone")
            << here.width() << QRect(here.width() + 300, 120, 1300, 800) << 1;
    }
    void aSmallerScreenHoldsIt()
    {
        QFETCH(const int, screenPixels);
        QFETCH(const QRect, window);
        QFETCH(const int, screen);
        QSettings().setValue(
            QStringLiteral("window/geometry"), keptOn(screenPixels, window, screen));
        test::WindowFixture fixture(test::headFirstSupine());
        fixture.window.restoreLayout();
        QGuiApplication::sync();
        QTRY_VERIFY2(screenRect().contains(fixture.window.geometry()),
            qPrintable(QStringLiteral("%1, %2")
                           .arg(fixture.window.geometry().right())
                           .arg(fixture.window.geometry().bottom())));
        // What fits keeps its size.
        if (window.width() < screenRect().width())
            QCOMPARE(fixture.window.size(), window.size());
    }
};

BURIN_WINDOW_TEST(WindowPlaceUiTest)

} // namespace windowPlaceUiTest

#include "WindowPlaceUiTest.moc"
