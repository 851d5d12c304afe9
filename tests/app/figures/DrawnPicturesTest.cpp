// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

namespace drawnPicturesTest {

namespace {

[[nodiscard]] QString textOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(path));
    return QString::fromUtf8(file.readAll());
}

} // namespace

/// packaging/pictures.sh draws every picture of the manual, but for what packaging/bench.sh draws
/// of its figures: one that no test of its list draws under that name stays as it was once,
/// whatever becomes of the program.
class DrawnPicturesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyPictureHasATestThatDrawsIt()
    {
        const QString source = QStringLiteral(BURIN_SOURCE_DIR);
        const QString script = textOf(source + QStringLiteral("/packaging/pictures.sh"));
        const QString benchmarks = textOf(source + QStringLiteral("/packaging/bench.sh"));
        QString drawers;
        QDirIterator tests(source + QStringLiteral("/tests"), {QStringLiteral("*Test.cpp")},
            QDir::Files, QDirIterator::Subdirectories);
        int listed = 0;
        while (tests.hasNext()) {
            const QString path = tests.next();
            const QRegularExpression name(
                QStringLiteral("\\b%1\\b").arg(QFileInfo(path).completeBaseName()));
            if (!name.match(script).hasMatch())
                continue;
            drawers += textOf(path);
            ++listed;
        }
        QVERIFY2(listed > 5, "the script lists next to no test");
        const QStringList pictures = QDir(source + QStringLiteral("/resources/help"))
                                         .entryList({QStringLiteral("*.png")}, QDir::Files);
        QVERIFY(!pictures.empty());
        QStringList undrawn;
        for (const QString& picture : pictures) {
            const bool ofFigures =
                benchmarks.contains(QStringLiteral("/resources/help/%1\"").arg(picture));
            if (!ofFigures && !drawers.contains(QStringLiteral("%1\"").arg(picture)))
                undrawn += picture;
        }
        QVERIFY2(undrawn.empty(), qPrintable(undrawn.join(QLatin1Char(' '))));
    }
};

BURIN_TEST(DrawnPicturesTest)

} // namespace drawnPicturesTest

#include "DrawnPicturesTest.moc"
