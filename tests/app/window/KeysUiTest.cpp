// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"

#include <QAction>
#include <QMap>
#include <QTest>

namespace keysUiTest {

/// The keys of the whole window, as all of its parts together give them.
class KeysUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// One that two actions ask for does neither.
    void noKeyIsGivenTwice()
    {
        test::ApplicationFixture fixture;
        QMap<QString, QString> owners;
        int keys = 0;
        for (const QAction* action : fixture.window().actionTable().all()) {
            for (const QKeySequence& key : action->shortcuts()) {
                const QString text = key.toString(QKeySequence::PortableText);
                QVERIFY2(!owners.contains(text),
                    qPrintable(QStringLiteral("%1: '%2' and '%3'")
                                   .arg(text, owners.value(text), action->text())));
                owners.insert(text, action->text());
                ++keys;
            }
        }
        QVERIFY2(keys > 50, qPrintable(QString::number(keys)));
        // Views and their tools have these: slices, lens, what is drawn or watched.
        for (const char* key : {"Z", "Space", "Esc", "Return", "Enter", "Backspace", "Left",
                 "Right", "Up", "Down", "PgUp", "PgDown", "Home", "End"})
            QVERIFY2(!owners.contains(QLatin1String(key)), key);
    }

    /// Each press lifts another cut: a key that is held down lifts one.
    void aHeldKeyLiftsOnce()
    {
        test::ApplicationFixture fixture;
        QVERIFY(!fixture.window().actionTable()[QStringLiteral("pieces.lift")].autoRepeat());
    }
};

BURIN_WINDOW_TEST(KeysUiTest)

} // namespace keysUiTest

#include "KeysUiTest.moc"
