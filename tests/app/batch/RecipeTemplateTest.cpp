// SPDX-License-Identifier: Apache-2.0
#include "app/batch/RecipeTemplate.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

namespace recipeTemplateTest {

/// What a recipe with placeholders becomes for a study of a list.
class RecipeTemplateTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    /// The recipe, filled for the only study of the list.
    [[nodiscard]] QJsonObject filled(
        const QByteArray& recipe, const char* list, const QByteArray& studies) const
    {
        const auto write = [this](const char* name, const QByteArray& text) {
            QFile file(m_folder.filePath(QLatin1String(name)));
            if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
                qFatal("cannot write %s", name);
            return file.fileName();
        };
        const auto read = app::RecipeTemplate::read(write("recipe.json", recipe));
        const auto all = app::readStudyList(write(list, studies));
        if (!read || !all || all->size() != 1)
            return {};
        const auto made = read->filled(all->front(), m_folder.filePath(QStringLiteral("out")));
        return made ? QJsonDocument::fromJson(*made).object() : QJsonObject();
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void cellsAreTextsWhereTextsBelong()
    {
        const QJsonObject made = filled(R"({
            "edits": [{"edit": "addSegment", "name": "${id}", "color": "#336699",
                       "code": ["SCT", "${code}", "Bone ${mm}"]},
                      {"edit": "grow", "lower": "${id}", "upper": "${mm}"}],
            "export": [{"format": "csv", "file": "${patient}.csv"},
                       {"format": "carved-volume", "file": "${id}", "fill": "${mm}"}]})",
            "list.csv", "study,patient,id,mm,code\nx.nii,0012,4711,1.50,24028007\n");
        const QJsonValue segment = made[QStringLiteral("edits")][0];
        QCOMPARE(segment[QStringLiteral("name")], QJsonValue(QStringLiteral("4711")));
        QCOMPARE(segment[QStringLiteral("code")],
            QJsonValue(QJsonArray{
                QStringLiteral("SCT"), QStringLiteral("24028007"), QStringLiteral("Bone 1.50")}));
        const QJsonValue growth = made[QStringLiteral("edits")][1];
        QCOMPARE(growth[QStringLiteral("lower")], QJsonValue(4711.0));
        QCOMPARE(growth[QStringLiteral("upper")], QJsonValue(1.5));
        const QJsonValue statistics = made[QStringLiteral("export")][0];
        QCOMPARE(statistics[QStringLiteral("file")], QJsonValue(QStringLiteral("0012.csv")));
        const QJsonValue carved = made[QStringLiteral("export")][1];
        QCOMPARE(carved[QStringLiteral("file")], QJsonValue(QStringLiteral("4711")));
        QCOMPARE(carved[QStringLiteral("fill")], QJsonValue(1.5));
    }

    /// JSON tells itself what is a text.
    void valuesOfJsonKeepTheirKind()
    {
        const QJsonObject made = filled(
            R"({"edits": [{"edit": "addSegment", "name": "${id}", "color": "#336699"},
                          {"edit": "addSegment", "name": "a ${number}", "color": "#336699"},
                          {"edit": "grow", "lower": "${number}"}]})",
            "list.json", R"([{"study": "x.nii", "id": "4711", "number": 7}])");
        const QJsonValue edits = made[QStringLiteral("edits")];
        QCOMPARE(edits[0][QStringLiteral("name")], QJsonValue(QStringLiteral("4711")));
        QCOMPARE(edits[1][QStringLiteral("name")], QJsonValue(QStringLiteral("a 7")));
        QCOMPARE(edits[2][QStringLiteral("lower")], QJsonValue(7.0));
    }
};

BURIN_TEST(RecipeTemplateTest)

} // namespace recipeTemplateTest

#include "RecipeTemplateTest.moc"
