// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/RecentStudies.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/OwnSettings.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

namespace recentStudiesTest {

class RecentStudiesTest : public QObject {
    Q_OBJECT

private:
    /// A folder that stands for a study.
    [[nodiscard]] QString study(const QString& name) const
    {
        const QString path = m_folder.filePath(name);
        QDir().mkpath(path);
        return path;
    }

    test::OwnSettings m_settings;
    QTemporaryDir m_folder;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        test::OwnSettings::clear();
    }

    void theyComeBackWithTheirDrive()
    {
        const QString onDrive = study(QStringLiteral("drive/pictures"));
        const QString series = QStringLiteral("+spacing=1x1x2");
        ui::RecentStudies::add(onDrive, series);
        const QString drive = m_folder.filePath(QStringLiteral("drive"));
        const QString unplugged = m_folder.filePath(QStringLiteral("unplugged"));
        QVERIFY(QDir().rename(drive, unplugged));
        const QString here = study(QStringLiteral("here"));
        ui::RecentStudies::add(here);
        QCOMPARE(ui::RecentStudies::paths(), QStringList{here});
        QVERIFY(QDir().rename(unplugged, drive));
        QCOMPARE(ui::RecentStudies::paths(), (QStringList{here, onDrive}));
        QCOMPARE(ui::RecentStudies::seriesOf(onDrive), series);
    }

    void thoseThatAreGoneTakeNobodysPlace()
    {
        constexpr int kept = ui::RecentStudies::kept;
        QStringList present;
        for (int i = 0; i < kept + 2; ++i) {
            present.prepend(study(QStringLiteral("study %1").arg(i)));
            ui::RecentStudies::add(present.front());
        }
        QCOMPARE(ui::RecentStudies::paths(), present.mid(0, kept));
        for (int i = 0; i < kept; ++i)
            ui::RecentStudies::add(m_folder.filePath(QStringLiteral("gone %1").arg(i)));
        QCOMPARE(ui::RecentStudies::paths(), present.mid(0, kept));
        // The list does not grow for ever.
        for (int i = 0; i < 3 * kept; ++i)
            ui::RecentStudies::add(m_folder.filePath(QStringLiteral("also gone %1").arg(i)));
        QCOMPARE(ui::RecentStudies::paths(), QStringList());
    }
};

BURIN_TEST(RecentStudiesTest)

} // namespace recentStudiesTest

#include "RecentStudiesTest.moc"
