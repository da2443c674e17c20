#include "codegen/image_writer.hpp"
