"""Speed against error: points, chart and tables of measurements of accuracy."""
