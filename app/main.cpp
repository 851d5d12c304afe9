// SPDX-License-Identifier: Apache-2.0
#include "app/CommandLine.h"
#include "app/commands/DecodeCommand.h"
#include "app/end/SuddenEnd.h"

int main(int argc, char** argv)
{
    if (app::isDecoder(argc, argv))
        return app::runDecoder();
    app::watchForSuddenEnd();
    app::nameDecoders();
    return app::runCommandLine(argc, argv);
}
