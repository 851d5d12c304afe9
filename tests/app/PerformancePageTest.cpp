// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/servers/Python.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace performancePageTest {

/// packaging/performance.py makes a page of the manual of what the benchmarks have measured.
class PerformancePageTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] QString written(const char* name, const QByteArray& text) const
    {
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write %s", name);
        return file.fileName();
    }
    [[nodiscard]] test::ScriptOutput page(const QByteArray& figures) const
    {
        return test::runProgram(QStringLiteral("/usr/bin/python3"),
            {QStringLiteral(BURIN_SOURCE_DIR "/packaging/performance.py"),
                written("figures.json", figures),
                written("graphics.txt",
                    "GL_RENDERER  llvmpipe (LLVM 15)\nGL_VERSION   4.5 Mesa 22.3.6\n")});
    }

private Q_SLOTS:
    void goalsAreMetOrNot()
    {
        const test::ScriptOutput made = page(
            R"([{"id":"frame.mip","oursMs":100.0,"peer":"VTK GPU mapper","peerMs":270.0,"ratio":2.7},
             {"id":"frame.mip","oursMs":100.0,"peer":"VTK fixed-point mapper","peerMs":270.0,"ratio":2.7},
             {"id":"steer.slider","oursMs":99.5},
             {"id":"steer.words","oursBytes per 1000":17000.0},
             {"id":"history.drill.bytes","oursBytes":1234.0,"peer":"full copy","peerBytes":12340.0,"ratio":10.0}])");
        QVERIFY2(made.exitCode == 0, made.output.constData());
        QVERIFY(made.output.contains("- graphics: llvmpipe (LLVM 15), OpenGL 4.5 Mesa 22.3.6\n"));
        QVERIFY(made.output.contains("- machine: "));
        for (const char* line :
            {"| picture at full quality | `frame.mip` | 100 ms | VTK GPU mapper: "
             "270 ms | 2.70 | at least 6 times as fast | no |\n",
                "| picture at full quality | `frame.mip` | 100 ms | VTK fixed-point mapper: 270 ms "
                "| 2.70 | at least 2 times as fast | yes |\n",
                "| `steer.slider` | 99.5 ms |  |  | at most 100 ms | yes |\n",
                "| `steer.words` | 17000 bytes per 1000 |  |  |\n",
                "| `history.drill.bytes` | 1234 bytes | full copy: 12340 bytes | 10.00 |\n",
                "- oblique plane with contour: `plane\\.(linear|cubic)`, "
                "vtkImageReslice + vtkCutter\n"})
            QVERIFY2(made.output.contains(line), (line + ("\n" + made.output)).constData());
        // What is there is not said to be missing.
        QVERIFY(!made.output.contains("- an event of the interval slider"));
    }

    void withoutFiguresAllIsMissing()
    {
        const test::ScriptOutput made = page("[]");
        QVERIFY2(made.exitCode == 0, made.output.constData());
        QVERIFY(made.output.contains("Not measured in this run:"));
        QVERIFY(!made.output.contains("## Other figures"));
        QVERIFY(!made.output.contains("| yes |"));
        QVERIFY(page("no figures").exitCode != 0);
    }
};

BURIN_TEST(PerformancePageTest)

} // namespace performancePageTest

#include "PerformancePageTest.moc"
