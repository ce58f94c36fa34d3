#pragma once

// What tests include on top: Catch2.
#include "Precompiled.hpp"

#include <catch2/catch.hpp>
