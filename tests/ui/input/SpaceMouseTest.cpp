// SPDX-License-Identifier: Apache-2.0
#include "ui/input/SpaceMouse.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/servers/SpaceDriver.h"

#include <QSignalSpy>
#include <QTest>

#include <vector>

namespace spaceMouseTest {

using test::SpaceDriver;

namespace {

/// What a device's movements and buttons come to, in order.
struct Heard {
    explicit Heard(ui::SpaceMouse& mouse)
    {
        QObject::connect(&mouse, &ui::SpaceMouse::moved, &mouse,
            [this](const ui::SpaceMotion& motion) { motions.push_back(motion); });
        QObject::connect(
            &mouse, &ui::SpaceMouse::buttonChanged, &mouse, [this](int button, bool pressed) {
                buttons.push_back({button, pressed});
                motionsBefore.push_back(motions.size());
            });
    }
    [[nodiscard]] glm::dvec3 pushed() const
    {
        glm::dvec3 sum(0.0);
        for (const ui::SpaceMotion& motion : motions)
            sum += motion.push;
        return sum;
    }
    std::vector<ui::SpaceMotion> motions;
    std::vector<std::pair<int, bool>> buttons;
    std::vector<std::size_t> motionsBefore; ///< how many were heard before each button
};

bool near(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::length(a - b) < 1e-9;
}

} // namespace

/// A device's driver is heard as its protocol says, and no nonsense of it does harm.
class SpaceMouseTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void withoutADriverNothingHappens()
    {
        ui::SpaceMouse mouse;
        QVERIFY(!mouse.connectTo(QStringLiteral("/nowhere/spnav.sock")));
        QVERIFY(!mouse.connectTo(QString()));
        QVERIFY(!mouse.connectTo(QString(4000, QLatin1Char('a'))));
        QVERIFY(!mouse.connected());
    }

    void theSocketIsFoundAsOtherProgramsDo()
    {
        qunsetenv("SPNAV_SOCKET");
        QCOMPARE(ui::SpaceMouse::usualSocket(), QStringLiteral("/var/run/spnav.sock"));
        qputenv("SPNAV_SOCKET", "/tmp/elsewhere");
        QCOMPARE(ui::SpaceMouse::usualSocket(), QStringLiteral("/tmp/elsewhere"));
        qunsetenv("SPNAV_SOCKET");
    }

    void axesAreTheUsers()
    {
        SpaceDriver driver;
        ui::SpaceMouse mouse;
        Heard heard(mouse);
        QVERIFY(mouse.connectTo(driver.socketPath()));
        QVERIFY(driver.accept());
        driver.say(SpaceDriver::motion({350, -175, 70, 35, 0, -350}, 20));
        QTRY_COMPARE(heard.motions.size(), std::size_t(1));
        QVERIFY(near(heard.motions[0].push, 0.02 * glm::dvec3(1.0, -0.5, -0.2)));
        QVERIFY(near(heard.motions[0].turn, 0.02 * glm::dvec3(0.1, 0.0, 1.0)));
    }

    void whatWaitsIsAddedUp()
    {
        SpaceDriver driver;
        ui::SpaceMouse mouse;
        Heard heard(mouse);
        QVERIFY(mouse.connectTo(driver.socketPath()));
        QVERIFY(driver.accept());
        for (int i = 0; i < 40; ++i)
            driver.say(SpaceDriver::motion({35, 0, 0, 0, 0, 0}, 10));
        QTRY_VERIFY(near(heard.pushed(), glm::dvec3(0.04, 0.0, 0.0)));
        QCOMPARE(heard.motions.size(), std::size_t(1));
    }

    void buttonsKeepTheirPlaceAmongMovements()
    {
        SpaceDriver driver;
        ui::SpaceMouse mouse;
        Heard heard(mouse);
        QVERIFY(mouse.connectTo(driver.socketPath()));
        QVERIFY(driver.accept());
        driver.say(SpaceDriver::motion({350, 0, 0, 0, 0, 0}));
        driver.say(SpaceDriver::button(1, true));
        driver.say(SpaceDriver::motion({350, 0, 0, 0, 0, 0}));
        driver.say(SpaceDriver::button(1, false));
        QTRY_COMPARE(heard.buttons.size(), std::size_t(2));
        QCOMPARE(heard.buttons[0], std::make_pair(1, true));
        QCOMPARE(heard.buttons[1], std::make_pair(1, false));
        QCOMPARE(heard.motionsBefore, (std::vector<std::size_t>{1, 2}));
    }

    void recordsMayComeInPieces()
    {
        SpaceDriver driver;
        ui::SpaceMouse mouse;
        Heard heard(mouse);
        QVERIFY(mouse.connectTo(driver.socketPath()));
        QVERIFY(driver.accept());
        const SpaceDriver::Record record = SpaceDriver::motion({0, 350, 0, 0, 0, 0});
        const auto* bytes = reinterpret_cast<const char*>(record.data());
        driver.sayBytes(bytes, 13);
        QTest::qWait(20);
        QVERIFY(heard.motions.empty());
        driver.sayBytes(bytes + 13, sizeof(record) - 13);
        QTRY_COMPARE(heard.motions.size(), std::size_t(1));
        QVERIFY(near(heard.motions[0].push, glm::dvec3(0.0, 0.01, 0.0)));
    }

    void nonsenseIsBounded()
    {
        SpaceDriver driver;
        ui::SpaceMouse mouse;
        Heard heard(mouse);
        QVERIFY(mouse.connectTo(driver.socketPath()));
        QVERIFY(driver.accept());
        driver.say({77, 1, 2, 3, 4, 5, 6, 7}); // no record that is known here
        driver.say(SpaceDriver::motion({INT32_MAX, INT32_MIN, 0, 0, 0, 0}, INT32_MAX));
        driver.say(SpaceDriver::motion({0, 0, 0, 0, 0, INT32_MIN}, -5));
        QTRY_VERIFY(!heard.motions.empty() && heard.motions.back().turn.z > 0.0);
        QVERIFY(near(heard.pushed(), 0.05 * glm::dvec3(1.0, -1.0, 0.0)));
        QCOMPARE(heard.buttons.size(), std::size_t(0));
    }

    void aDriverMayEndAndBeginAnew()
    {
        ui::SpaceMouse mouse;
        Heard heard(mouse);
        SpaceDriver driver;
        QVERIFY(mouse.connectTo(driver.socketPath()));
        QVERIFY(driver.accept());
        driver.sayBytes("half", 4);
        driver.hangUp();
        QTRY_VERIFY(!mouse.connected());
        QVERIFY(mouse.connectTo(driver.socketPath()));
        QVERIFY(driver.accept());
        driver.say(SpaceDriver::motion({350, 0, 0, 0, 0, 0}));
        QTRY_COMPARE(heard.motions.size(), std::size_t(1)); // the half record is forgotten
        QVERIFY(near(heard.motions[0].push, glm::dvec3(0.01, 0.0, 0.0)));
    }
};

BURIN_TEST(SpaceMouseTest)

} // namespace spaceMouseTest

#include "SpaceMouseTest.moc"
