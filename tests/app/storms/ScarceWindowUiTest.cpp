// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/servers/BurinProgram.h"

#include <QFile>
#include <QImage>
#include <QTest>

namespace scarceWindowUiTest {

using test::key;
using test::Outcome;

/// The window opens a session where there is little memory, or there are few file handles: it shows
/// the session, or ends with a word; what is in the session is whole either way.
class ScarceWindowUiTest : public QObject, test::CommandFixture {
    Q_OBJECT

    QStringList m_hashes;

private Q_SLOTS:
    void initTestCase()
    {
        if (test::underSanitizer)
            QSKIP("a sanitizer needs more than there would be");
        QVERIFY(prepareStudy());
    }
    void init()
    {
        makeFolder();
        const QJsonArray edits = test::toJson({test::addSegment("A"), test::drillAt(0)});
        QCOMPARE(run(recipe("r.json", {{key("edits"), edits}}), "a.burin").status, 0);
        m_hashes = hashes("a.burin");
        QCOMPARE(m_hashes.size(), 2);
    }

    void showsItOrSaysWhyNot_data()
    {
        QTest::addColumn<int>("megabytes");
        QTest::addColumn<int>("handles");
        QList<int> limits{450, 900};
        QList<int> handles{16, 64};
        if (test::longRun()) {
            limits = {200, 300, 400, 500, 600, 700, 800, 900, 1000, 1200, 1500, 2000, 2500};
            handles = {8, 12, 13, 14, 16, 20, 24, 32, 48, 63, 64, 70, 80, 128};
        }
        for (const int each : limits)
            QTest::addRow("%d MB", each) << each << 0;
        for (const int each : handles)
            QTest::addRow("%d handles", each) << 0 << each;
    }
    void showsItOrSaysWhyNot()
    {
        QFETCH(int, megabytes);
        QFETCH(int, handles);
        test::Surroundings around;
        around.addressSpaceBytes = std::size_t(megabytes) << 20;
        around.openFiles = handles;
        for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
            around.variables.insert(QLatin1String(name), path(name));
        const Outcome outcome = test::burin({key("open"), path("a.burin"), key("--screenshot"),
                                                path("p.png"), key("--size"), key("900x600")},
            around);
        qInfo("status %d %s", outcome.status,
            qPrintable(outcome.complaint.trimmed().section(u'\n', -1)));
        QVERIFY2(outcome.status != Outcome::hung, qPrintable(outcome.complaint));
        QVERIFY(outcome.status == 0 || !outcome.complaint.isEmpty());
        QVERIFY(QFile::exists(path("p.png")) == (outcome.status == 0));
        // The window is as small as it can be, where it cannot be as small as that.
        QVERIFY(outcome.status != 0 || QImage(path("p.png")).width() >= 900);
        if (handles > 0) {
            QCOMPARE(outcome.status, handles < 64 ? 1 : 0);
            QVERIFY(handles >= 64 || outcome.complaint.contains(key("64 file handles")));
        }
        // What a program that ended at once has left open is recovered.
        QCOMPARE(hashes("a.burin"), m_hashes);
        const Outcome verified = test::burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
    }
};

BURIN_WINDOW_TEST(ScarceWindowUiTest)

} // namespace scarceWindowUiTest

#include "ScarceWindowUiTest.moc"
