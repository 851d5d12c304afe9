// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Arguments.h"
#include "core/base/Result.h"
#include "core/sources/PacsSource.h"

#include <vector>

namespace app {

/// Options of every verb that talks to a source.
[[nodiscard]] std::vector<Option> sourceOptions();

/// The source that the first word (an address, or the name of one in the settings) and the options
/// of sourceOptions() name. Logins come out of files and the environment: a command line is there
/// for all to read. InvalidField, errors of core::WebLogin.
[[nodiscard]] core::Result<core::PacsSource> sourceOf(const Arguments& arguments);

} // namespace app
