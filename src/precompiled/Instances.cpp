// With a definition of the macro, the header's declarations compile the templates.
#define NAOCAL_INSTANCE template
#include "Instances.hpp"
