// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/fuzz/FuzzBytes.h"

namespace test {

// Doors of core through which bytes of strangers come: each opens a file of these bytes as the
// program would, and returns whatever they are. One file holds those that need the same of core.

void fuzzDicom(FuzzBytes bytes);
void fuzzSeg(FuzzBytes bytes);
void fuzzRtStruct(FuzzBytes bytes);
void fuzzNifti(FuzzBytes bytes);
void fuzzPackedNifti(FuzzBytes bytes);
void fuzzNrrd(FuzzBytes bytes);
void fuzzMetaImage(FuzzBytes bytes);
/// Headers alone, beside a file of voxels.
void fuzzNrrdHeader(FuzzBytes bytes);
void fuzzMetaHeader(FuzzBytes bytes);
void fuzzProbability(FuzzBytes bytes);
void fuzzImages(FuzzBytes bytes);
void fuzzMesh(FuzzBytes bytes);
void fuzzSession(FuzzBytes bytes);
void fuzzDelta(FuzzBytes bytes);
void fuzzSurfaceStep(FuzzBytes bytes);
void fuzzRecipe(FuzzBytes bytes);
void fuzzMultipart(FuzzBytes bytes);
void fuzzWebAnswer(FuzzBytes bytes);
void fuzzArchive(FuzzBytes bytes);
/// What a decoder that an image has taken over sends to the program: messages, each of which begins
/// with its length in two bytes.
void fuzzDecoderReply(FuzzBytes bytes);
/// A request as a decoder reads it, and the memory that goes with it.
void fuzzDecoderRequest(FuzzBytes bytes);

} // namespace test
