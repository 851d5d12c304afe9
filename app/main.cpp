// SPDX-License-Identifier: Apache-2.0
#include "app/CommandLine.h"
#include "app/DecodeCommand.h"

int main(int argc, char** argv)
{
    if (app::isDecoder(argc, argv))
        return app::runDecoder();
    app::nameDecoders();
    return app::runCommandLine(argc, argv);
}
