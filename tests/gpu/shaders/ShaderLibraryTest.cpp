// SPDX-License-Identifier: Apache-2.0
#include "gpu/shaders/ShaderLibrary.h"
#include "tests/support/program/TestProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace shaderLibraryTest {

using gpu::ShaderError;
using gpu::ShaderLibrary;
using gpu::ShaderSource;

class ShaderLibraryTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    void write(const char* name, const QByteArray& text)
    {
        QFile file(m_folder.filePath(QString::fromLatin1(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    [[nodiscard]] ShaderLibrary library() const { return ShaderLibrary(m_folder.path()); }
    [[nodiscard]] QString errorOf(const char* name) const
    {
        try {
            (void)library().load(QString::fromLatin1(name));
        } catch (const ShaderError& error) {
            return QString::fromUtf8(error.what());
        }
        return {};
    }

private Q_SLOTS:
    void beginsWithVersionAndDefines()
    {
        write("plain.comp", "void main() {}\n");
        const ShaderSource source = library().load(QStringLiteral("plain.comp"), {{"SIDE", 16}});
        QVERIFY(source.text.startsWith("#version 450 core\n#define SIDE 16\n#line 1 0\n"));
        QVERIFY(source.text.contains("void main() {}"));
    }

    void includesEachFileOnceAndKeepsLines()
    {
        write("a.glsl", "int a;\n");
        write("b.glsl", "#include \"a.glsl\"\nint b;\n");
        write("top.frag", "int before;\n#include \"a.glsl\"\n#include \"b.glsl\"\nint after;\n");
        const ShaderSource source = library().load(QStringLiteral("top.frag"));
        QCOMPARE(source.text.count("int a;"), 1);
        QCOMPARE(source.files,
            QStringList(
                {QStringLiteral("top.frag"), QStringLiteral("a.glsl"), QStringLiteral("b.glsl")}));
        // The line after the second include is line 4 of file 0.
        const qsizetype after = source.text.indexOf("int after;");
        QVERIFY(source.text.left(after).endsWith("#line 4 0\n"));
    }

    void showsTheChainOfACycle()
    {
        write("x.glsl", "#include \"y.glsl\"\n");
        write("y.glsl", "\n#include \"x.glsl\"\n");
        const QString error = errorOf("x.glsl");
        QVERIFY2(error.contains(QStringLiteral("y.glsl:2")), qPrintable(error));
        QVERIFY2(error.contains(QStringLiteral("x.glsl → y.glsl → x.glsl")), qPrintable(error));
    }

    void namesWhoIncludesAMissingFile()
    {
        write("lonely.frag", "#include \"nowhere.glsl\"\n");
        const QString error = errorOf("lonely.frag");
        QVERIFY2(error.contains(QStringLiteral("lonely.frag")), qPrintable(error));
        QVERIFY2(error.contains(QStringLiteral("nowhere.glsl")), qPrintable(error));
    }

    void mapsDriverMessages_data()
    {
        QTest::addColumn<QString>("driver");
        QTest::addColumn<QString>("mapped");
        QTest::newRow("Mesa") << QStringLiteral("1:12(5): error: x undeclared")
                              << QStringLiteral("b.glsl:12: error: x undeclared");
        QTest::newRow("NVIDIA") << QStringLiteral("0(7) : error C1008: x")
                                << QStringLiteral("a.frag:7 : error C1008: x");
        QTest::newRow("AMD") << QStringLiteral("ERROR: 0:3: 'x' : undeclared")
                             << QStringLiteral("ERROR: a.frag:3: 'x' : undeclared");
        QTest::newRow("unknown file")
            << QStringLiteral("9:3(1): error") << QStringLiteral("9:3(1): error");
    }

    void mapsDriverMessages()
    {
        QFETCH(QString, driver);
        QFETCH(QString, mapped);
        ShaderSource source;
        source.files = {QStringLiteral("a.frag"), QStringLiteral("b.glsl")};
        QCOMPARE(source.withFileNames(driver), mapped);
    }

    void carriesItsFilesInTheProgram()
    {
        const ShaderSource source =
            ShaderLibrary::builtIn().load(QStringLiteral("shaders/fullScreen.vert"));
        QVERIFY(source.text.contains("gl_VertexID"));
    }
};

BURIN_TEST(ShaderLibraryTest)

} // namespace shaderLibraryTest

#include "ShaderLibraryTest.moc"
