// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/OwnDisplay.h"
#include "tests/support/program/TestProgram.h"

#include <QApplication>

#include <memory>

namespace test {

struct WindowApplication::Parts {
    std::unique_ptr<OwnDisplay> display;
    std::unique_ptr<QApplication> application;
};

WindowApplication::WindowApplication(int& argc, char** argv)
    : m_parts(new Parts)
{
    if (qgetenv("BURIN_TEST_DISPLAY") != "inherit")
        m_parts->display = std::make_unique<OwnDisplay>();
    m_parts->application = std::make_unique<QApplication>(argc, argv);
    // As QTEST_MAIN does: the same sizes on every display.
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true);
}

WindowApplication::~WindowApplication()
{
    // The connection goes before its server does.
    m_parts->application.reset();
    delete m_parts;
}

} // namespace test
