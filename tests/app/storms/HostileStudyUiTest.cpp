// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/defective/HostileStudy.h"
#include "ui/frame/MessageBar.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace hostileStudyUiTest {

namespace {

void store(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

} // namespace

/// Hostile files in the window.
class HostileStudyUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachIsRefusedInWordsAndAStudyOpensAfterIt();
};

/// All in one window, one after the other: what one of them left behind would hurt the next.
void HostileStudyUiTest::eachIsRefusedInWordsAndAStudyOpensAfterIt()
{
    test::ApplicationFixture fixture;
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("hostile.dcm"));
    for (const test::HostileFile& hostile : test::hostileFiles()) {
        store(file, hostile.bytes);
        fixture.window().opener().open(file);
        const auto told = [&] { return !fixture.bar().isEmpty() || fixture.workspace().session(); };
        QVERIFY2(
            QTest::qWaitFor(told, test::ApplicationFixture::patience), qPrintable(hostile.name));
        QVERIFY2(!fixture.workspace().session(), qPrintable(hostile.name));
        fixture.window().messages().dismiss();
    }
    const QString study = folder.filePath(QStringLiteral("study"));
    QDir().mkpath(study);
    test::writeHonestSeries(study);
    fixture.open(study);
    QCOMPARE(fixture.session().document().volumes.front().sources.size(),
        std::size_t(test::honestSlices));
}

BURIN_WINDOW_TEST(HostileStudyUiTest)

} // namespace hostileStudyUiTest

#include "HostileStudyUiTest.moc"
