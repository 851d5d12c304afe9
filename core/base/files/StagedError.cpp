// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedError.h"

#include "core/base/files/StagedFile.h"

namespace core {

Error namingTarget(Error error, const StagedFile& staged)
{
    error.arguments.replace(staged.path(), staged.target());
    return error;
}

} // namespace core
