// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <vector>

namespace drawnPicturesTest {

namespace {

[[nodiscard]] QString textOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(path));
    return QString::fromUtf8(file.readAll());
}

[[nodiscard]] QDir manual()
{
    return QDir(QStringLiteral(BURIN_SOURCE_DIR "/resources/help"));
}

[[nodiscard]] QStringList pictures()
{
    return manual().entryList({QStringLiteral("*.png")}, QDir::Files);
}

struct ShownPicture {
    QString page;
    QString words; ///< that stand for it where it is not seen
    QString file;
};

/// What the pages of the manual show, in their order.
[[nodiscard]] std::vector<ShownPicture> shownPictures()
{
    static const QRegularExpression picture(QStringLiteral("!\\[([^\\]]*)\\]\\(([^)]*)\\)"));
    std::vector<ShownPicture> shown;
    for (const QString& page : manual().entryList({QStringLiteral("*.md")}, QDir::Files)) {
        const QString text = textOf(manual().filePath(page));
        for (auto each = picture.globalMatch(text); each.hasNext();) {
            const QRegularExpressionMatch match = each.next();
            shown.push_back({page, match.captured(1), match.captured(2)});
        }
    }
    return shown;
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
        QStringList wanted = pictures();
        QVERIFY(!wanted.empty());
        for (const ShownPicture& each : shownPictures())
            wanted += each.file;
        wanted.removeDuplicates();
        QStringList undrawn;
        for (const QString& picture : wanted) {
            const bool ofFigures =
                benchmarks.contains(QStringLiteral("/resources/help/%1\"").arg(picture));
            if (!ofFigures && !drawers.contains(QStringLiteral("%1\"").arg(picture)))
                undrawn += picture;
        }
        QVERIFY2(undrawn.empty(), qPrintable(undrawn.join(QLatin1Char(' '))));
    }

    /// A page whose picture is missing shows a broken one; packaging/pictures.sh draws it.
    void whatPagesShowIsThere()
    {
        const std::vector<ShownPicture> shown = shownPictures();
        QVERIFY(shown.size() > 20);
        const QStringList present = pictures();
        QStringList missing;
        for (const ShownPicture& each : shown) {
            if (!present.contains(each.file))
                missing += QStringLiteral("%1 (%2)").arg(each.file, each.page);
            QVERIFY2(!each.words.isEmpty(), qPrintable(each.file));
        }
        QVERIFY2(missing.empty(), qPrintable(missing.join(QLatin1Char(' '))));
    }
};

BURIN_TEST(DrawnPicturesTest)

} // namespace drawnPicturesTest

#include "DrawnPicturesTest.moc"
