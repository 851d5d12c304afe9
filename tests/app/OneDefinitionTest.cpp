// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <map>

namespace oneDefinitionTest {

namespace {

/// The types that a file defines in named namespaces, with them. Files are formatted by one tool,
/// so that what stands at the beginning of a line is in no class and in no function.
QStringList typesIn(const QString& text)
{
    static const QRegularExpression opens(QStringLiteral("^(?:inline )?namespace ?([\\w:]*) ?\\{"));
    static const QRegularExpression closes(QStringLiteral("^\\} // namespace"));
    static const QRegularExpression type(QStringLiteral(
        "^(?:template <.*> )?(?:struct|class|enum class|enum|union) (\\w+)(?: final)?"
        "(?: : [^;]*)?(?: \\{|$)"));
    QStringList types;
    QStringList spaces;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        if (const auto match = opens.match(line); match.hasMatch()) {
            spaces.append(match.captured(1));
        } else if (closes.match(line).hasMatch()) {
            if (!spaces.isEmpty())
                spaces.removeLast();
        } else if (const auto found = type.match(line); found.hasMatch()) {
            if (!spaces.contains(QString())) // what is unnamed is the file's own
                types.append((spaces + QStringList(found.captured(1))).join(QStringLiteral("::")));
        }
    }
    return types;
}

} // namespace

/// A name of a type stands for one type. Where two files define different ones, functions that the
/// compiler makes for both (constructors, destructors, those of std::vector) have one name, and the
/// linker takes either: a vector of one then has room for the other, and no compiler says so.
class OneDefinitionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void typesAreFound_data();
    void typesAreFound();
    void aNameIsOneType();
};

void OneDefinitionTest::typesAreFound_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("types");
    const auto row = [](const char* text, const QStringList& types) {
        QTest::addRow("%s", text) << QString::fromUtf8(text) << types;
    };
    row("namespace core {\nstruct A {\n    struct B {\n    };\n};\n", {QStringLiteral("core::A")});
    row("namespace a::b {\nclass A final : public B {\n", {QStringLiteral("a::b::A")});
    row("namespace core {\nenum class A {\n} // namespace core\nstruct B\n{\n",
        {QStringLiteral("core::A"), QStringLiteral("B")});
    row("namespace core {\ntemplate <class T> struct A {\n", {QStringLiteral("core::A")});
    row("namespace core {\nstruct A;\nclass B;\nstruct A a;\nstruct A::B {\n", {});
    row("namespace core {\n\nnamespace {\nstruct A {\n} // namespace\nstruct B {\n",
        {QStringLiteral("core::B")});
}

void OneDefinitionTest::typesAreFound()
{
    QFETCH(const QString, text);
    QFETCH(const QStringList, types);
    QCOMPARE(typesIn(text), types);
}

void OneDefinitionTest::aNameIsOneType()
{
    const QDir top(QStringLiteral(BURIN_SOURCE_DIR));
    std::map<QString, QString> known; // by type: its file
    QStringList wrong;
    for (const char* room : {"core", "gpu", "ui", "app", "tests"}) {
        QDirIterator walk(top.filePath(QLatin1String(room)),
            {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
            QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            QFile file(walk.next());
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            const QString path = top.relativeFilePath(file.fileName());
            for (const QString& type : typesIn(QString::fromUtf8(file.readAll()))) {
                const auto [place, isNew] = known.emplace(type, path);
                if (!isNew)
                    wrong += QStringLiteral("%1 is defined in %2 and in %3")
                                 .arg(type, place->second, path);
            }
        }
    }
    QVERIFY2(known.size() > 1000, "the walk found next to nothing: is BURIN_SOURCE_DIR right?");
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

BURIN_TEST(OneDefinitionTest)

} // namespace oneDefinitionTest

#include "OneDefinitionTest.moc"
