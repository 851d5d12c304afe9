// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/Recipe.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cmath>

namespace manualRecipesTest {

namespace {

QString read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// What stands between ```json and ``` on a page.
QStringList snippetsOf(const QString& page)
{
    QStringList snippets;
    const QString opening = QStringLiteral("```json\n");
    for (qsizetype at = page.indexOf(opening); at >= 0; at = page.indexOf(opening, at)) {
        at += opening.size();
        snippets += page.mid(at, page.indexOf(QLatin1String("```"), at) - at);
    }
    return snippets;
}

/// A page may list edits one below the other, without what makes a recipe of them.
QByteArray recipeOf(const QString& snippet)
{
    if (snippet.contains(QLatin1String("\"edits\"")))
        return snippet.toUtf8();
    QString list = snippet.trimmed();
    list.replace(QLatin1String("}\n{"), QLatin1String("},\n{"));
    return QByteArray("{\"edits\": [") + list.toUtf8() + "]}";
}

/// The numbers of a place, or of the places in a list.
void addNumbers(const QJsonValue& value, QJsonArray& numbers)
{
    if (!value.isArray())
        return numbers.append(value);
    for (const QJsonValue& each : value.toArray())
        addNumbers(each, numbers);
}

} // namespace

/// Recipes that the manual and the README show are recipes.
class ManualRecipesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void areRead_data()
    {
        QTest::addColumn<QByteArray>("recipe");
        const QDir source(QStringLiteral(BURIN_SOURCE_DIR));
        const QDir help(source.filePath(QStringLiteral("resources/help")));
        QStringList pages{source.filePath(QStringLiteral("README.md"))};
        for (const QString& name : help.entryList({QStringLiteral("*.md")}, QDir::Files))
            pages += help.filePath(name);
        for (const QString& page : pages) {
            int number = 0;
            for (const QString& snippet : snippetsOf(read(page)))
                QTest::addRow("%s: %d", qPrintable(QFileInfo(page).fileName()), ++number)
                    << recipeOf(snippet);
        }
    }

    void areRead()
    {
        QFETCH(const QByteArray, recipe);
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("recipe.json")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(recipe) == recipe.size());
        file.close();
        const core::Result<core::Recipe> taken = core::readRecipe(file.fileName());
        QVERIFY2(taken, taken ? "" : qPrintable(ui::errorText(taken.error())));
        QVERIFY(!taken->steps.empty());
    }

    /// Whoever tries them on the demonstration head, as the page says, is not told that places lie
    /// beside it.
    void placesOfGrowthAreInTheDemonstrationHead()
    {
        const QString page = read(QStringLiteral(BURIN_SOURCE_DIR "/resources/help/growth.md"));
        constexpr std::array<double, 3> halfMm{115.0, 115.0, 100.0};
        int places = 0;
        for (const QString& snippet : snippetsOf(page)) {
            const QJsonObject recipe = QJsonDocument::fromJson(recipeOf(snippet)).object();
            for (const QJsonValue& edit : recipe[QLatin1String("edits")].toArray()) {
                const QJsonObject fields = edit.toObject();
                for (const char* name : {"pointsLps", "pointLps", "placeLps", "originLps",
                         "bubbleLps", "furtherBubblesLps"}) {
                    QJsonArray numbers;
                    if (fields.contains(QLatin1String(name)))
                        addNumbers(fields[QLatin1String(name)], numbers);
                    for (qsizetype i = 0; i < numbers.size(); ++i) {
                        QVERIFY2(std::abs(numbers[i].toDouble()) < halfMm[std::size_t(i % 3)],
                            qPrintable(fields[QLatin1String("edit")].toString()));
                        ++places;
                    }
                }
            }
        }
        QVERIFY(places >= 30);
    }
};

BURIN_TEST(ManualRecipesTest)

} // namespace manualRecipesTest

#include "ManualRecipesTest.moc"
