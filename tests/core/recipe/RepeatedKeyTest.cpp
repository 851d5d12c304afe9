// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RepeatedKey.h"
#include "core/recipe/Recipe.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace repeatedKeyTest {

using namespace core;

/// A key that stands twice in an object is a mistake, not the last one's right.
class RepeatedKeyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void isFound_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QString>("key");
        QTest::addColumn<int>("line");
        const auto row = [](const char* name, const char* json, const char* key, int line) {
            QTest::newRow(name) << QByteArray(json) << QString::fromUtf8(key) << line;
        };
        row("none", "{\"a\":1,\"b\":{\"a\":2},\"c\":[{\"a\":3},{\"a\":4}]}", "", 0);
        row("empty", "{}", "", 0);
        row("a value like a key", "{\"a\":\"b\",\"b\":\"a\",\"c\":[\"a\",\"a\"]}", "", 0);
        row("at once", "{\"a\":1,\"a\":1}", "a", 1);
        row("behind an object", "{\n\"a\":{\"x\":1},\n\"b\":2,\n\"a\" : 3}", "a", 4);
        row("inside", "[{\"e\":[\n{\"k\":1,\"k\":2}]}]", "k", 2);
        row("escaped", "{\"a\\\"b\":1,\"a\\\"b\":2}", "a\"b", 1);
        row("by its number", "{\"a\":1,\"\\u0061\":2}", "a", 1);
        row("braces in text", "{\"a\":\"}{\",\"b\":\"\\\\\",\"a\":0}", "a", 1);
    }
    void isFound()
    {
        QFETCH(QByteArray, json);
        QFETCH(QString, key);
        QFETCH(int, line);
        const std::optional<RepeatedKey> found = repeatedKey(json);
        QCOMPARE(found.has_value(), line > 0);
        if (!found)
            return;
        QCOMPARE(found->key, key);
        QCOMPARE(found->line, line);
    }

    void aRecipeWithOneIsRefused()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("r.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"edits\": [\n{\"edit\": \"addSegment\", \"name\": \"A\", \"name\": \"B\", "
                   "\"color\": \"#ff0000\"}]}");
        file.close();
        const Result<Recipe> recipe = readRecipe(file.fileName());
        QVERIFY(!recipe);
        QCOMPARE(recipe.error().code, ErrorCode::InvalidRecipe);
        QVERIFY(recipe.error().arguments.value(1).contains(u"line 2"));
        QVERIFY(recipe.error().arguments.value(1).contains(u"'name'"));
    }
};

BURIN_TEST(RepeatedKeyTest)

} // namespace repeatedKeyTest

#include "RepeatedKeyTest.moc"
