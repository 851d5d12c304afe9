// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/meshfile/MeshReader.h"

namespace test {

using namespace core;

void fuzzMesh(FuzzBytes bytes)
{
    const ScratchFile file("file.mesh", bytes);
    for (auto* read : {readStl, readObj, readPly, readGltf})
        (void)read(file.path());
}

} // namespace test
